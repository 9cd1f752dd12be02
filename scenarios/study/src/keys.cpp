// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/study.hpp"

namespace tandem::study {
namespace {

using text::KeyList;

void of_file(KeyList& to) {
  using enum text::Key::Type;
  to.may("scenario", text,
         "The scenario that is run, relative to the study's folder. In the table [study] of a scenario: "
         "without it, that scenario.",
         {.allowed = "a file, or \"$COLUMN\""})
      .may(
          "steps", name,
          "A factor of all own steps and of the communication step. Sampled subsystems keep their instants. "
          "The "
          "parameter that makes an own step is found by trial: `step`, one whose value is the own step, or a "
          "rate `steps_per_..`.",
          {.allowed = "a number, `\"$COLUMN\"` or `\"$(EXPRESSION)\"`"})
      .may("columns", texts, "What a row has first, in this order: columns and metrics. The others follow.")
      .table("lists", "Values that axes name: an array, or a table of columns that move together.")
      .may("NAME", any, "A list.", {.allowed = "an array, `{ range = .. }`, or a table of these"})
      .table("set",
             "Keys of the scenario (those of `--set`) with what each is set to, in tables that have the "
             "columns in it.")
      .may("NAME", any, "In quotes where it has dots.",
           {.allowed =
                "a number, true, false, a text, `\"$COLUMN\"` or `\"$(EXPRESSION)\"` of columns; a condition "
                "alone, `\"$((COLUMN is WORD))\"`, is true or false"});
}

void of_tables(KeyList& to) {
  using enum text::Key::Type;
  to.named("tables", "Tables of rows, each written to TABLE.csv. Without it there is a search.", "One table.")
      .may("columns", texts, "In place of the study's.")
      .may("metrics", texts, "Those that it has. Without it: all.")
      .may("scenario", text, "In place of the study's.", {.allowed = "as the study's"})
      .may("models", flag,
           "Linear models run in the subsystems' places, as in a reference. A row whose subsystems have none "
           "is "
           "refused.",
           {.otherwise = "false"})
      .table(
          "tables.NAME.set",
          "Keys of its scenario, besides those that the study sets; of a scenario of its own: these alone.")
      .may("NAME", any, "In quotes where it has dots.", {.allowed = "as in `[set]`"})
      .table("tables.NAME.blocks[]", "Rows of it: blocks add up in the order of the file.", true)
      .need(
          "axes", any,
          "Each a table of columns that move together, or the name of a list; axes multiply, the last one "
          "first.",
          {.allowed =
               "an array of tables and texts; a column is an array, `\"$LIST\"`, or `{ range = { "
               "from, to, count, spacing } }` "
               "with the spacing `linear` or `log`. `drawn` and `drawn_log` are by chance: the same for the "
               "same name of a column and the same `--seed`"})
      .may("where", text, "Leaves rows out where it is 0.", {.allowed = "an expression of columns"});
}

void of_choices(KeyList& to) {
  using enum text::Key::Type;
  to.named(
        "choices",
        "What one table chooses, and what another one says of it: how good a prediction is. It is written to "
        "NAME.csv, of the columns in `per`, then `advised`, `best`, `advised_error`, `best_error` and "
        "`rank`.",
        "One table of choices. Rows are grouped by the columns of `per`; the words of their other columns, "
        "with spaces between, are a scheme. Of the rows whose `least` "
        "is "
        "within 1 % of the smallest the one with the least `cost` is advised. Its `rank` is 1 more than the "
        "number "
        "of those with a smaller error. What is not known counts as infinite.")
      .need("by", text, "The table that chooses.", {.allowed = "a table"})
      .need("of", text, "The table that judges.", {.allowed = "a table with the same rows"})
      .need("least", text, "By what it chooses.", {.allowed = "a metric of the first"})
      .need("cost", text, "By what it chooses among equal ones.", {.allowed = "a metric of the first"})
      .need("error", text, "By what it is judged.", {.allowed = "a metric of the second"})
      .may("per", texts, "Columns: a choice for each of their values.");
}

void of_references(KeyList& to) {
  using enum text::Key::Type;
  to.named("references", "What metrics compare with.", "One reference: results (`file`), or a run.")
      .may("file", text, "Results, a CSV or .npy file, relative to the study's folder.")
      .may("scenario", text,
           "Of a run: the scenario, relative to the study's folder. Without it: the study's.",
           {.allowed = "a file, or \"$COLUMN\""})
      .may("per", texts,
           "Columns: one run for each of their values. Those that a table has not are left out.")
      .may("floor", flag,
           "A second run, with half the own steps and the communication step, tells the error of the "
           "reference itself, as METRIC.floor.",
           {.otherwise = "false"})
      .may(
          "models", flag,
          "Linear models run in its subsystems' places, found beforehand "
          "(docs/advice.md); sampled "
          "subsystems run themselves. Where any other has no model the reference fails, and a note names it.",
          {.otherwise = "false"})
      .table("references.NAME.with", "Columns that have another value in it: a finer run.")
      .may("NAME", name, "The value.",
           {.allowed = "a number, a word, `\"$COLUMN\"` or `\"$(EXPRESSION)\"` of the columns in `per`"})
      .table("references.NAME.set",
             "Keys of its scenario, besides those that the study sets; of another scenario: these alone.")
      .may("NAME", any, "In quotes where it has dots.", {.allowed = "as in `[set]`"})
      .table("references.NAME.outputs", "Outputs that have another name in it.")
      .may("NAME", text, "By the name in the study: that in the reference.");
}

void of_metrics(KeyList& to) {
  using enum text::Key::Type;
  to.named(
        "metrics", "Numbers that each row has.",
        "One metric. Counts go by their names alone: `exchanges = {}` (calls of subsystems) and "
        "`\"steps.INSTANCE\" = {}` (own steps). So do times: `seconds = {}` (wall time, and processor time "
        "as seconds.processor), `\"share.INSTANCE\" = {}` and `real_time_factor = {}`. A table has times if "
        "its `metrics` name them, or if it is the only one. So do three of the map of a super-step "
        "(docs/stability.md): `spectral_radius = {}`, `damping = {}` and `detuning = {}`. A row with these "
        "alone is not run. Else one of `of`, `signal`, `drift`, `order`, "
        "`formula`, `builtin`, `defect` and `energy`.")
      .may("of", text,
           "An output, compared with that of a reference at the rows of the one that has fewer. The other is "
           "interpolated by Hermite polynomials. Where it has no derivatives, rows at equal times count "
           "alone. "
           "Without a reference: the output itself.",
           {.allowed = "\"instance.port\" or \"instance.port[i]\""})
      .may("signal", text,
           "An expression over time, at the rows of the output that stands first in it. OUTPUT.REFERENCE is "
           "an output of a reference.",
           {.allowed = "an expression of outputs, their derivatives der(OUTPUT), and columns"})
      .may("drift", text, "A signal that should stay as it is at the start: its departure from there.",
           {.allowed = "as of `signal`"})
      .may("order", text,
           "The observed order of a metric that stands before it: log2 of its ratio to what it is with all "
           "own steps and the communication step halved, by a second run.",
           {.allowed = "a metric"})
      .may("formula", text, "Of other metrics and columns.", {.allowed = "an expression"})
      .may("builtin", text, "What only code can tell, by its name.")
      .may("defect", text, "The largest defect of an input (docs/indicators.md).",
           {.allowed = "\"instance.port\", as in indicators.csv"})
      .may("energy", text, "What the coupling made on a link (docs/indicators.md) [J].",
           {.allowed = "\"EFFORT:BACK\", as in indicators.csv"})
      .may("norm", word,
           "Of it over time: largest magnitude, root mean square, last magnitude; without a reference "
           "also the least and the largest value.",
           {.otherwise = "max", .words = {"max", "rms", "end", "least", "most"}})
      .may("relative", word,
           "It is divided by the peak of the reference, or by its rms; of a drift by the magnitude at the "
           "`start`. "
           "Without it: it is not.",
           {.words = {"peak", "rms", "start"}})
      .may("scale", name, "It is multiplied by this.", {.allowed = "a number, or an expression of columns"})
      .may("against", text,
           "The reference. Without it: the only one, if there is one. A `builtin` that compares with one "
           "gets its output "
           "`with.output`.",
           {.allowed = "a reference, or `none`: the output itself"})
      .may("from", number, "The first time that counts. Without it: the first.", {.unit = "s"})
      .may("to", number, "The last one. Without it: the last.", {.unit = "s"})
      .may("shift", positive,
           "The run may be so much later or earlier as a whole; by how much it is is told as METRIC.shift.",
           {.unit = "s"})
      .may("unit", text, "That the number is told in. Without it: that of the output.")
      .may("otherwise", any,
           "This stands in the cell of a run that does not tell it, or failed. Without it the cell is empty.",
           {.allowed = "a number, or inf"})
      .may("repetitions", positive,
           "Of `seconds` and `real_time_factor`: the least of so many runs, of which the one that is "
           "judged is the first.",
           {.otherwise = "3"})
      .may("state", text,
           "Of `damping` and `detuning`: that of the mode in which this state takes part most. Without it: "
           "the mode "
           "that is farthest off.",
           {.allowed = "\"instance.state\""})
      .table("metrics.NAME.with", "Parameters of a `builtin`.")
      .may("NAME", any, "As it knows it.", {.allowed = "as in `[set]`"});
}

void of_searches(KeyList& to) {
  using enum text::Key::Type;
  to.table(
        "search[]",
        "The largest or smallest value of a column for which a condition holds, by bisection: a table of its "
        "own, with the metrics of the run at that value.")
      .need("name", text, "Its rows are written to NAME.csv.")
      .need("column", text, "The column that is searched for; it is in no axis.")
      .need("from", positive, "The smallest value.")
      .need("to", positive, "The largest value.")
      .may("find", word, "Which value: a condition holds up to the largest, or from the smallest on.",
           {.otherwise = "largest", .words = {"largest", "smallest"}})
      .need("holds", text, "A run whose status is not ok never does.",
            {.allowed = "an expression of metrics and columns"})
      .may("precision", positive, "Of the value, relative.", {.otherwise = "0.01"})
      .may("scan", positive,
           "A factor above 1: values are tried by it from the end where it holds, up to the first where it "
           "does "
           "not; then bisection. Without it: by bisection between both ends.")
      .may("nowhere", any, "What stands where it holds nowhere. Without it: nothing.",
           {.allowed = "a number, or inf"})
      .may("everywhere", any, "What stands where it holds up to the other end. Without it: that end.",
           {.allowed = "a number, or inf"})
      .need("axes", any, "A search for each row of these.", {.allowed = "as in a block"})
      .may("where", text, "Leaves rows out where it is 0.", {.allowed = "an expression of columns"});
}

void of_kept(KeyList& to) {
  using enum text::Key::Type;
  to.table("keep[]", "Runs whose outputs over time are written to TABLE.series.csv.")
      .need("name", text, "In the column `kept`.")
      .may("table", text, "Without it: the only one.")
      .may("where", text, "Rows of it. Without it: all.", {.allowed = "an expression of columns and metrics"})
      .may("least", text, "Of these the one with the smallest value.", {.allowed = "a metric"})
      .may("most", text, "Of these the one with the largest value.", {.allowed = "a metric"})
      .may("per", texts, "Columns: one for each of their values.")
      .need("outputs", texts,
            "The first gives the times, the rows of its subsystem. Others are interpolated there.")
      .may("metrics", texts, "Metrics with `signal` or `drift`, over time.")
      .may("against", text,
           "The reference whose outputs stand beside them, as OUTPUT.REFERENCE. Without it: the "
           "only one, if there is one.",
           {.allowed = "a reference, or `none`"})
      .may("every", positive, "Rows are at least so far apart. Without it: all rows.", {.unit = "s"});
}

void of_verdicts(KeyList& to) {
  using enum text::Key::Type;
  to.table("lost", "Rows whose status is `lost`, besides those that diverge.")
      .need("when", text, "Where it is not 0.", {.allowed = "an expression of metrics and columns"})
      .table("unstable", "Rows whose status is `unstable`.")
      .need("when", text, "Where it is not 0.", {.allowed = "an expression of metrics and columns"});
}

}  // namespace

const text::Keys& keys() {
  static const text::Keys all = [] {
    KeyList list;
    for (const auto part :
         {of_file, of_tables, of_searches, of_references, of_metrics, of_verdicts, of_choices, of_kept})
      part(list);
    charts::add_keys(list);
    return text::Keys(std::move(list).list());
  }();
  return all;
}

}  // namespace tandem::study
