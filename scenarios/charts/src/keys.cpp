// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/chart.hpp"

namespace tandem::charts {
namespace {

using text::KeyList;

constexpr const char* a_number = "a column, or an expression of columns";
constexpr const char* columns = "a column, or an array of columns";

void of_panels(KeyList& to) {
  using enum text::Key::Type;
  to.may("panels", edge, "A panel for each value that these columns have.", {.allowed = columns})
      .may("across", positive, "Panels side by side. Without it: all, up to four.");
}

void of_points(KeyList& to) {
  using enum text::Key::Type;
  of_panels(to);
  to.may("percent", flag, "The numbers of the y axis are shown as percentages.", {.otherwise = "false"})
      .may("limit", positive,
           "Larger y are no results: they stand in the grey band above, with rows whose status is not ok.")
      .may("hollow", text, "Markers are hollow where it is not 0, or has no value.",
           {.allowed = "an expression of columns"})
      .may("floor", text,
           "A line at its largest value, the error of a reference. Without it: the column Y.floor, where "
           "there is one.",
           {.allowed = "an expression of columns"})
      .may("slope", vector, "Lines of these orders, from the middle of the points.")
      .may("tolerance", positive, "A line at this y.")
      .may("lines", any, "Lines over all panels.",
           {.allowed = "an array of tables `{ y = NUMBER, name = TEXT }`, or with x"})
      .may("overlay", any, "Points of a second table that has the same x and y.",
           {.allowed = "a table `{ table = TABLE, name = TEXT, where = EXPRESSION }`"});
}

void of_curves(KeyList& to) {
  using enum text::Key::Type;
  to.kind("curves", "y over x, a line for each series.")
      .need("x", text, "Words stand side by side, in the order of the table.", {.allowed = a_number})
      .need("y", any, "A row of panels for each.",
            {.allowed =
                 "a column, an expression, or an array of these; an inner array has several in one panel"})
      .may("series", edge, "A line for each value that these columns have.", {.allowed = columns})
      .may("log", edge, "Axes that are logarithmic.", {.allowed = "\"x\", \"y\", or an array of both"});
  of_points(to);
}

void of_work(KeyList& to) {
  using enum text::Key::Type;
  to.kind("work", "Error over cost, both axes logarithmic.")
      .need("cost", any, "A row of panels for each.",
            {.allowed = "a column, an expression, or an array of these"})
      .need("error", any, "A row of panels for each.",
            {.allowed = "a column, an expression, or an array of these"})
      .may("colour", edge, "A colour for each value that these columns have.", {.allowed = columns})
      .may("marker", edge, "A marker for each value that these columns have.", {.allowed = columns})
      .may("join", flag, "Lines join points of one colour and marker.", {.otherwise = "false"})
      .may("front", flag, "The points for which no other is as cheap and as accurate.",
           {.otherwise = "false"});
  of_points(to);
}

void of_map(KeyList& to) {
  using enum text::Key::Type;
  to.kind("map", "A cell for each row and column, shaded by a value.")
      .need("rows", edge, "A row for each value of these.", {.allowed = columns})
      .need("columns", text, "A column for each value of this.", {.allowed = "a column"})
      .need("value", text, "The smaller the darker.", {.allowed = a_number})
      .need("limits", vector, "Where shades end, one to six, rising. Larger values have none.")
      .may("percent", flag, "Limits are shown as percentages.", {.otherwise = "false"})
      .may("signs", any, "The first that holds stands in the cell.",
           {.allowed = "an array of up to three tables `{ when = EXPRESSION, name = TEXT }`"})
      .may("text", text, "The first letter of what it has stands in each cell.", {.allowed = "a column"})
      .may("best", positive, "The smallest value of each column is marked, unless it is larger than this.")
      .may("also", any, "The best of the cells for which this holds is marked too.",
           {.allowed = "a table `{ when = EXPRESSION, name = TEXT }`"});
  of_panels(to);
}

void of_traces(KeyList& to) {
  using enum text::Key::Type;
  to.kind("traces", "Time series, panels one below the other.")
      .need("y", any, "A panel for each.",
            {.allowed =
                 "a column, an expression, or an array of these; an inner array has several in one panel"})
      .may("x", text, "In place of the time.", {.otherwise = "time", .allowed = a_number})
      .may("series", edge, "A line for each value that these columns have.", {.allowed = columns})
      .may("panels", edge, "A panel for each value that these columns have.", {.allowed = columns})
      .may("windows", any, "Each beside the one before.", {.allowed = "an array of [FROM, TO] of x"})
      .may("difference", text, "Below each panel: y less the column Y.NAME.",
           {.allowed = "NAME, a reference"})
      .may("jumps", text, "Dotted lines where this column changes.", {.allowed = "a column"});
}

void of_tables(KeyList& to) {
  using enum text::Key::Type;
  to.kind("table", "A table in Markdown, NAME.md.")
      .need("rows", edge, "A row for each value of these.", {.allowed = columns})
      .may("columns", text, "A column for each value of this. Without it: one for each of `cells`.",
           {.allowed = "a column"})
      .need("cells", any, "What stands in each; of several in a cell the others stand in brackets.",
            {.allowed = "a column, an expression, or an array of these"})
      .may("each", edge, "What the values of several rows in a cell make. Without it a cell has one row.",
           {.allowed = "`sum`, `mean`, `least` or `most`, or one of these for each of `cells`"})
      .may("digits", positive, "Significant digits of numbers that are not whole.", {.otherwise = "2"});
}

}  // namespace

void add_keys(KeyList& to) {
  using enum text::Key::Type;
  to.table("names", "Words for what stands in tables and charts.")
      .may("NAME", text, "What a column or a word is called.")
      .table("charts[]", "Pictures of tables.")
      .by_kind()
      .need("name", text, "The stem of its files.", {.allowed = "letters, digits and _"})
      .need("kind", word, "What it is.", {.words = {"curves", "work", "map", "traces", "table"}})
      .may("table", text,
           "TABLE.csv in the folder of results, or if it is not there beside this file. Without it: the "
           "only one that there is.")
      .may("title", text, "Stands above it.")
      .may("notes", texts, "Lines below it.")
      .may("words", any, "As `[names]`, of this chart alone.", {.allowed = "a table of texts"})
      .may("where", text, "The rows that it draws. Without it: all.",
           {.allowed = "an expression of columns"});
  for (const auto kind : {of_curves, of_work, of_map, of_traces, of_tables}) kind(to);
}

const text::Keys& keys() {
  static const text::Keys all = [] {
    KeyList list;
    add_keys(list);
    return text::Keys(std::move(list).list());
  }();
  return all;
}

}  // namespace tandem::charts
