// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "command.hpp"

namespace tandem::study_metrics_tests {
namespace {

using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

/// The column of a table, by row.
std::vector<double> column_of(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  std::string line, cell;
  std::getline(lines, line);
  std::istringstream header(line);
  int which = 0;
  while (std::getline(header, cell, ',') && cell != name) ++which;
  std::vector<double> numbers;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (int k = 0; k <= which; ++k) std::getline(cells, cell, ',');
    numbers.push_back(std::stod(cell));
  }
  return numbers;
}

/// Of a pendulum alone, without damping: the integrator is of order 2, and what stays is its energy.
TEST(Study, MetricsHaveTheOrderOfTheIntegrator) {
  const Scratch folder;
  folder.write("s.toml", "scenario = '" TANDEM_SOURCE_DIR R"(/scenarios/mechanisms/pendulum/pendulum.toml'
[set]
"run.step" = "$step"
"run.stop" = 2.0
[[tables.steps.blocks]]
axes = [{ step = [0.01, 0.005, 0.0025] }]
[references.fine]
with = { step = 1e-4 }
[metrics]
largest = { of = "pendulum.x" }
rms = { of = "pendulum.x", norm = "rms" }
end = { of = "pendulum.x", norm = "end", unit = "mm" }
fraction = { of = "pendulum.x", norm = "rms", relative = "rms", scale = "2*step/step" }
late = { of = "pendulum.x", from = 1.5 }
energy = { drift = "pendulum.energy" }
twice = { formula = "largest + fraction*0 + largest" }
"steps.pendulum" = {}
)");
  const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const std::string table = read_text(folder.path() / "o/steps.csv");
  for (const char* name : {"largest", "rms", "end", "fraction", "late", "energy"}) {
    const auto errors = column_of(table, name);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.2) << name << '\n' << table;
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.2) << name;
  }
  EXPECT_EQ(column_of(table, "steps.pendulum"), (std::vector<double>{200, 400, 800}));
  EXPECT_EQ(column_of(table, "twice")[1], 2 * column_of(table, "largest")[1]);
}

/// Of the same pendulum: a distance of two outputs from those of a reference, which are exact to 1e-8, and
/// the orders that it tells by itself.
TEST(Study, SignalsAreOfOutputsAndOfReferences) {
  const Scratch folder;
  folder.write("s.toml", "scenario = '" TANDEM_SOURCE_DIR R"toml(/scenarios/mechanisms/pendulum/pendulum.toml'
[set]
"run.step" = "$step"
"run.stop" = 2.0
[[tables.steps.blocks]]
axes = [{ step = [0.01, 0.005] }]
[references.fine]
with = { step = 1e-4 }
[references.finer]
with = { step = 5e-5 }
[metrics]
x = { of = "pendulum.x", against = "fine" }
x_as_signal = { signal = "pendulum.x - pendulum.x.fine" }
distance = { signal = "sqrt((pendulum.x - pendulum.x.fine)^2 + (pendulum.y - pendulum.y.fine)^2)", norm = "rms" }
of_references = { signal = "pendulum.x.fine - pendulum.x.finer" }
low = { signal = "pendulum.x", norm = "least" }
high = { of = "pendulum.x", norm = "most", against = "none" }
order = { order = "x" }
order_of_distance = { order = "distance" }
order_of_nothing = { order = "of_references" }
)toml");
  const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const std::string table = read_text(folder.path() / "o/steps.csv");
  const auto column = [&](const char* name) { return column_of(table, name); };
  EXPECT_EQ(column("x"), column("x_as_signal"));
  EXPECT_GT(column("distance")[0], 0.3 * column("x")[0]);
  EXPECT_NEAR(column("order")[0], std::log2(column("x")[0] / column("x")[1]), 1e-12);
  EXPECT_NEAR(column("order_of_distance")[0], 2.0, 0.2);
  EXPECT_EQ(column("order_of_nothing")[0], 0.0);
  EXPECT_LT(column("of_references")[0], 1e-3 * column("x")[1]);
  EXPECT_LT(column("low")[0], -0.1);
  EXPECT_GT(column("high")[0], 0.1);
}

TEST(Study, RefusesSignalsAndOrdersThatMeanNothing) {
  const struct {
    const char *metric, *said;
  } cases[] = {
      {"a = { signal = 'pendulum.q' }", "s.toml:8: output 'pendulum.q' is not there"},
      {"a = { signal = 'pendulum.x.fine - pendulum.q.fine' }",
       "reference fine: output 'pendulum.q' is not there"},
      {"a = { signal = '2*step' }", "s.toml:8: metrics.a: '2*step' names no output"},
      {"a = { signal = 'pendulum.x', relative = 'peak' }", "it is neither `of` nor `drift`"},
      {"a = { of = 'pendulum.x', norm = 'least' }", "allowed is max, rms or end, of a difference"},
      {"a = { order = 'b' }\nb = { of = 'pendulum.x' }", "metric before it 'b' is not there"},
      {"a = { of = 'pendulum.x', order = 'b' }", "a has 2 of `of`, `signal`, `drift`, `order`"},
  };
  for (const auto& [metric, sentence] : cases) {
    const Scratch folder;
    folder.write("s.toml", "scenario = '" TANDEM_SOURCE_DIR R"(/scenarios/mechanisms/pendulum/pendulum.toml'
[set]
"run.stop" = 0.1
"run.step" = "$step"
[tables.steps]
blocks = [{ axes = [{ step = [0.01] }] }]
[metrics]
)" + std::string(metric) + "\n[references.fine]\nwith = { step = 1e-3 }\n");
    const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
    EXPECT_EQ(said.status, 2) << metric;
    EXPECT_NE(said.err.find(sentence), std::string::npos) << metric << '\n' << said.err;
  }
}

}  // namespace
}  // namespace tandem::study_metrics_tests
