// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What becomes of the results: recorded, compared, judged, shown, and models compared by them.
#include "scenario/keys.hpp"

namespace tandem::scenario {
namespace {

using text::KeyList;

const std::string fraction = "a fraction of the largest magnitude";

}  // namespace

void keys_of_results(KeyList& to) {
  using enum text::Key::Type;
  to.table("record", "What the results have.")
      .may("clock", text,
           "At whose rows the results have theirs; `own`: a file for each subsystem with its own "
           "rows. Without it: at those of the one with the smallest first step.",
           {.allowed = "a subsystem, or `own`"})
      .may("ports", texts, "Outputs that are recorded. Without it: all.",
           {.allowed = "\"instance.port\" or \"instance.port[i]\""})
      .may("every", positive,
           "Rows are at least so far apart: the first at or after each multiple of it, both of a jump there, "
           "and "
           "the last. Without it: all.",
           {.unit = "s"})
      .may("from", number, "The first time that is recorded. Without it: that of the start.", {.unit = "s"})
      .may("to", number, "The last one. Without it: that of the end.", {.unit = "s"})
      .may("animate", flag, "Mechanisms tell where their points are, for `tandem view`.",
           {.otherwise = "false"})
      .table("reference", "Results that those of a run are compared with.")
      .need("file", text, "A CSV file, relative to the scenario's folder.")
      .need("tolerance", positive, "The largest difference that is allowed of a column.",
            {.allowed = fraction})
      .table("judge", "What the scene is judged by.")
      .need("quantity", text, "The output.", {.allowed = "\"instance.port\""})
      .need("tolerance", positive, "The difference that is good enough.", {.allowed = fraction})
      .table("view", "What the page of `tandem view` shows at first.")
      .may("plots", texts, "Outputs that are plotted.", {.allowed = "\"instance.port\""});
}

void keys_of_ladder(KeyList& to) {
  using enum text::Key::Type;
  to.table("ladder", "Models of the scene from simple to rich, for `tandem ladder`.")
      .may("set", texts, "Settings of all rungs of this file.", {.allowed = "\"KEY=VALUE\", as of `--set`"})
      .table("ladder.judged[]", "What rungs are judged by; without it `[judge]`.")
      .need("quantity", text, "The output.", {.allowed = "\"instance.port\""})
      .need("tolerance", positive, "The largest difference from the richest rung that is good enough.",
            {.allowed = "in `unit`, or " + fraction})
      .may("unit", text, "That of the tolerance. Without it: a fraction.")
      .table("ladder.rungs[]", "A model of the scene, the richest last.")
      .need("name", text, "Its name, also of its folder.",
            {.allowed = "without / \\ \" and a dot at its beginning"})
      .may("file", text, "Another scenario. Without it: this one.")
      .may("set", texts, "Settings of this rung.", {.allowed = "\"KEY=VALUE\""})
      .table("ladder.rungs[].outputs",
             "Judged quantities that this rung has by another name, or as a constant.")
      .may("NAME", name, "By the judged quantity: the output, or the number, that it is here.");
}

}  // namespace tandem::scenario
