// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What becomes of the results: recorded, compared, judged, shown, and models compared by them.
#include "tandem/scenario/keys.hpp"

namespace tandem::scenario {
namespace {

using text::KeyList;

const std::string fraction = "a fraction of the largest magnitude, or of the rms";

/// How a difference is measured.
void keys_of_measure(KeyList& to) {
  using enum text::Key::Type;
  to.may("norm", word,
         "Of the difference over time, and of what it is a fraction of: the largest, or the rms.",
         {.otherwise = "max", .words = {"max", "rms"}})
      .may("from", number, "The first time that counts. Without it: the first.", {.unit = "s"})
      .may("to", number, "The last one. Without it: the last.", {.unit = "s"})
      .may("shift", positive,
           "The run may be so much later or earlier as a whole; by how much it is is told beside the "
           "difference.",
           {.unit = "s"});
}

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
      .may("format", word,
           "Of the files of rows: text, or numpy's, with the bits of all numbers in less room.",
           {.otherwise = "csv", .words = {"csv", "npy"}})
      .may("derivatives", flag,
           "A column `der(instance.port)` stands beside each output that gives its derivative: results with "
           "it "
           "are interpolated by cubic Hermite polynomials where they are compared.",
           {.otherwise = "false"})
      .may("every", positive,
           "Rows are at least so far apart: the first at or after each multiple of it from the first "
           "recorded time on, "
           "both of a jump there, and the last of the run. Without it: all.",
           {.unit = "s"})
      .may("from", number, "The first time that is recorded. Without it: that of the start.", {.unit = "s"})
      .may("to", number, "The last one. Without it: that of the end.", {.unit = "s"})
      .may("indicators", word,
           "How far the coupling is off: indicators.csv (docs/indicators.md). `raw`: from what the run does "
           "anyway. "
           "`estimate`: also how far the judged output is off, by linear models.",
           {.otherwise = "raw", .words = {"raw", "off", "estimate"}})
      .may("animate", flag, "Mechanisms tell where their points are, for `tandem view`.",
           {.otherwise = "false"})
      .table("reference", "Results that those of a run are compared with.")
      .need("file", text,
            "A CSV file, one of numpy, or the folder of a run, relative to the scenario's folder.")
      .need("tolerance", positive, "The largest difference that is allowed of a column.",
            {.allowed = fraction});
  keys_of_measure(to);
  to.table("judge", "What the scene is judged by.")
      .need("quantity", text, "The output.", {.allowed = "\"instance.port\""})
      .need("tolerance", positive, "The difference that is good enough.", {.allowed = fraction});
  keys_of_measure(to);
  to.table("view", "What the page of `tandem view` shows at first.")
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
      .may("unit", text, "That of the tolerance. Without it: a fraction.");
  keys_of_measure(to);
  to.table("ladder.rungs[]", "A model of the scene, the richest last.", true)
      .need("name", text, "Its name, also of its folder.",
            {.allowed = "without / \\ \" and a dot at its beginning"})
      .may("file", text,
           "Another scenario, or results: a CSV file, one of numpy, or their folder. Without it: this "
           "scenario.")
      .may("set", texts, "Settings of this rung.", {.allowed = "\"KEY=VALUE\""})
      .table("ladder.rungs[].outputs",
             "Judged quantities that this rung has by another name, or as a constant in the unit of the "
             "richest rung that is a scenario.")
      .may("NAME", name, "By the judged quantity: the output, or the number, that it is here.");
}

}  // namespace tandem::scenario
