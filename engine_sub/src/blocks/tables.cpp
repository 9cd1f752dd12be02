// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "compile/refuse.hpp"
#include "data.hpp"
#include "kinds.hpp"
#include "made.hpp"
#include "tandem/text/series.hpp"

namespace tandem::engine {
namespace {

using Beyond = Curve::Beyond;

Curve::Between between(Arguments& a) {
  return a.word("interpolation") == 1 ? Curve::Between::cubic : Curve::Between::linear;
}

Beyond beyond(Arguments& a) {
  constexpr Beyond words[] = {Beyond::hold, Beyond::extend, Beyond::refuse};
  return words[a.word("beyond")];
}

/// Where the table says so, values of a signal before its first point and after its last.
void refuse_beyond(Lowering& to, int user, Range range, const std::vector<double>& points, Beyond beyond) {
  if (beyond != Beyond::refuse) return;
  range.low = points.front(), range.high = points.back();
  to.range(user, std::move(range));
}

/// A table of one variable.
void table(Lowering& to, Arguments& a) {
  const Curve curve =
      made(a, [&] { return Curve(a.owner(), a.numbers("x"), a.numbers("y"), between(a), beyond(a)); });
  const int input = a.wire("input"), y = to.curve(curve, input);
  refuse_beyond(to, y, {input, 0.0, 0.0, a.owner(), "its input"}, curve.x(), curve.beyond());
  to.define("", y);
}

/// A table of two variables: z has a row over y for each x.
void table2(Lowering& to, Arguments& a) {
  const auto inputs = a.wires("inputs");
  if (inputs.size() != 2) a.refuse("inputs", fmt::format("an array of {}", inputs.size()), "one of 2");
  const Surface::Grid grid{a.numbers("x"), a.numbers("y"), a.numbers("z")};
  const auto how = between(a);
  const auto outside = beyond(a);
  const int z =
      to.surface(made(a, [&] { return Surface(a.owner(), grid, how, outside); }), inputs[0], inputs[1]);
  refuse_beyond(to, z, {inputs[0], 0.0, 0.0, a.owner(), "its first input"}, grid.x, outside);
  refuse_beyond(to, z, {inputs[1], 0.0, 0.0, a.owner(), "its second input"}, grid.y, outside);
  to.define("", z);
}

/// A column of a file over time.
void csv(Lowering& to, Arguments& a) {
  const auto file = to.scope().folder / a.text("file");
  const auto name = a.text("column");
  const auto how = joining(a);
  define_data(to, a, made(a, [&] { return text::column_series(file, name, how); }));
}

/// How values are joined, and what holds beyond them.
void keys_of_tables(text::KeyList& to) {
  to.may("interpolation", Type::word, "How points are joined; `cubic` is monotone.",
         {.otherwise = "linear", .words = {"linear", "cubic"}})
      .may("beyond", Type::word, "Beyond the table: the last value, the last slope, or an error.",
           {.otherwise = "hold", .words = {"hold", "extend", "refuse"}});
}

}  // namespace

const std::vector<BlockKind> table_blocks = {
    {"table", table, "A table of one variable.",
     [](text::KeyList& to) {
       to.need("input", Type::signal, "The variable.")
           .need("x", Type::numbers, "Its values, which rise.")
           .need("y", Type::numbers, "Those of the output.");
       keys_of_tables(to);
     }},
    {"table2", table2, "A table of two variables.",
     [](text::KeyList& to) {
       to.need("inputs", Type::signals, "The variables x and y.", {.allowed = "two"})
           .need("x", Type::numbers, "Values of the first, which rise.")
           .need("y", Type::numbers, "Values of the second, which rise.")
           .need("z", Type::numbers, "Those of the output: for each x a row over y.");
       keys_of_tables(to);
     }},
    {"csv", csv, "A column of a CSV file over time.", [](text::KeyList& to) {
       to.need("file", Type::text, "The file, from the diagram's folder.")
           .need("column", Type::text, "The column, by its name in the first row.");
       text::keys_of_joining(to);
     }}};

}  // namespace tandem::engine
