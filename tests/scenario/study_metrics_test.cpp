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

}  // namespace
}  // namespace tandem::study_metrics_tests
