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
  return a.word("interpolation", {"linear", "cubic"}) == 1 ? Curve::Between::cubic : Curve::Between::linear;
}

Beyond beyond(Arguments& a) {
  constexpr Beyond words[] = {Beyond::hold, Beyond::extend, Beyond::refuse};
  return words[a.word("beyond", {"hold", "extend", "refuse"})];
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
  const auto file = to.scope().folder / a.required_text("file", "the name of a CSV file, in quotes");
  const auto name = a.required_text("column", "the name of a column");
  const bool hold = a.word("beyond", {"refuse", "hold"}) == 1;
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

}  // namespace

const std::vector<BlockKind> table_blocks = {{"table", table}, {"table2", table2}, {"csv", csv}};

}  // namespace tandem::engine
