// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "compile/refuse.hpp"
#include "kinds.hpp"
#include "made.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/time_table.hpp"

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

/// A table of one variable.
void table(Lowering& to, Arguments& a) {
  const Curve curve =
      made(a, [&] { return Curve(a.owner(), a.numbers("x"), a.numbers("y"), between(a), beyond(a)); });
  const int input = a.wire("input"), y = to.curve(curve, input);
  to.range(y, input, curve, a.owner(), "its input");
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
  to.range(z, inputs[0], {"", grid.x, grid.x, how, outside}, a.owner(), "its first input");
  to.range(z, inputs[1], {"", grid.y, grid.y, how, outside}, a.owner(), "its second input");
  to.define("", z);
}

/// The column of that name, whole.
const std::vector<double>& column(const text::TimeTable& table, const std::string& name, const Arguments& a) {
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    if (table.names[k] != name) continue;
    for (std::size_t row = 0; row < table.times.size(); ++row)
      if (std::isnan(table.columns[k][row]))
        refuse(fmt::format("{}:{}", table.file.string(), row + 2),
               "column " + name + " is empty; allowed for " + a.owner() + " is a number in each row");
    return table.columns[k];
  }
  refuse(a.where(),
         a.owner() + ", file " + table.file.string() + ": " + unknown("column", name, table.names));
}

/// A column of a file over time: straight lines between its rows.
void csv(Lowering& to, Arguments& a) {
  const auto file = to.scope().folder / a.text("file");
  const auto name = a.text("column");
  const bool hold = a.word("beyond") == 1;
  const Curve curve = made(a, [&] {
    const auto data = text::TimeTable::read(file);
    return Curve(a.owner() + ", file " + data.file.string() + ",", data.times, column(data, name, a),
                 Curve::Between::linear, hold ? Beyond::hold : Beyond::refuse);
  });
  for (const double t : curve.x()) to.kink(t);
  const int y = to.curve(curve, to.time());
  to.range(y, to.time(), curve, a.owner(), "time");
  to.define("", y);
}

/// How values are joined, and what holds beyond them.
void keys_of_joining(text::KeyList& to) {
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
       keys_of_joining(to);
     }},
    {"table2", table2, "A table of two variables.",
     [](text::KeyList& to) {
       to.need("inputs", Type::signals, "The variables x and y.", {.allowed = "two"})
           .need("x", Type::numbers, "Values of the first, which rise.")
           .need("y", Type::numbers, "Values of the second, which rise.")
           .need("z", Type::numbers, "Those of the output: for each x a row over y.");
       keys_of_joining(to);
     }},
    {"csv", csv, "A column of a CSV file over time; straight lines between its rows.", [](text::KeyList& to) {
       to.need("file", Type::text, "The file, from the diagram's folder.")
           .need("column", Type::text, "The column, by its name in the first row.")
           .may("beyond", Type::word, "Before the first row and after the last.",
                {.otherwise = "refuse", .words = {"refuse", "hold"}});
     }}};

}  // namespace tandem::engine
