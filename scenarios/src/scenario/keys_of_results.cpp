// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What becomes of the results: recorded, compared, judged, shown, and models compared by them.
#include "scenario/keys.hpp"

namespace tandem::scenario {
namespace {

using text::Key;
using Type = Key::Type;

const std::string fraction = "a fraction of the largest magnitude";

}  // namespace

std::vector<Key> keys_of_results() {
  return {
      {.path = "record", .type = Type::table, .sentence = "What the results have."},
      {.path = "record.clock",
       .type = Type::text,
       .sentence = "At whose rows the results have theirs; `own`: a file for each subsystem with its own "
                   "rows. Without "
                   "it: at those of the one with the smallest first step.",
       .allowed = "a subsystem, or `own`"},
      {.path = "record.ports",
       .type = Type::texts,
       .sentence = "Outputs that are recorded. Without it: all.",
       .allowed = "\"instance.port\" or \"instance.port[i]\""},
      {.path = "record.animate",
       .type = Type::flag,
       .sentence = "Mechanisms tell where their points are, for `tandem view`.",
       .otherwise = "false"},
      {.path = "reference",
       .type = Type::table,
       .sentence = "Results that those of a run are compared with."},
      {.path = "reference.file",
       .type = Type::text,
       .sentence = "A CSV file, relative to the scenario's folder.",
       .required = true},
      {.path = "reference.tolerance",
       .type = Type::positive,
       .sentence = "The largest difference that is allowed of a column.",
       .allowed = fraction,
       .required = true},
      {.path = "judge", .type = Type::table, .sentence = "What the scene is judged by."},
      {.path = "judge.quantity",
       .type = Type::text,
       .sentence = "The output.",
       .allowed = "\"instance.port\"",
       .required = true},
      {.path = "judge.tolerance",
       .type = Type::positive,
       .sentence = "The difference that is good enough.",
       .allowed = fraction,
       .required = true},
      {.path = "view", .type = Type::table, .sentence = "What the page of `tandem view` shows at first."},
      {.path = "view.plots",
       .type = Type::texts,
       .sentence = "Outputs that are plotted.",
       .allowed = "\"instance.port\""},
  };
}

std::vector<Key> keys_of_ladder() {
  return {
      {.path = "ladder",
       .type = Type::table,
       .sentence = "Models of the scene from simple to rich, for `tandem ladder`."},
      {.path = "ladder.set",
       .type = Type::texts,
       .sentence = "Settings of all rungs of this file.",
       .allowed = "\"KEY=VALUE\", as of `--set`"},
      {.path = "ladder.judged[]",
       .type = Type::tables,
       .sentence = "What rungs are judged by; without it `[judge]`."},
      {.path = "ladder.judged[].quantity",
       .type = Type::text,
       .sentence = "The output.",
       .allowed = "\"instance.port\"",
       .required = true},
      {.path = "ladder.judged[].tolerance",
       .type = Type::positive,
       .sentence = "The largest difference from the richest rung that is good enough.",
       .allowed = "in `unit`, or " + fraction,
       .required = true},
      {.path = "ladder.judged[].unit",
       .type = Type::text,
       .sentence = "That of the tolerance. Without it: a fraction."},
      {.path = "ladder.rungs[]", .type = Type::tables, .sentence = "A model of the scene, the richest last."},
      {.path = "ladder.rungs[].name",
       .type = Type::text,
       .sentence = "Its name, also of its folder.",
       .allowed = "without / \\ \" and a dot at its beginning",
       .required = true},
      {.path = "ladder.rungs[].file",
       .type = Type::text,
       .sentence = "Another scenario. Without it: this one."},
      {.path = "ladder.rungs[].set",
       .type = Type::texts,
       .sentence = "Settings of this rung.",
       .allowed = "\"KEY=VALUE\""},
      {.path = "ladder.rungs[].outputs",
       .type = Type::table,
       .sentence = "Judged quantities that this rung has by another name, or as a constant."},
      {.path = "ladder.rungs[].outputs.NAME",
       .type = Type::name,
       .sentence = "By the judged quantity: the output, or the number, that it is here."},
  };
}

}  // namespace tandem::scenario
