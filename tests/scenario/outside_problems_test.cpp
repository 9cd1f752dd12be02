// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The oscillators of others (scenarios/oscillator/udc.toml, precice.toml) beside their exact motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "long_run.hpp"

namespace tandem::outside_problems_tests {
namespace {

using namespace test;

test::Recording::Rows rows_of(const scenario::Scenario& one, int subsystem) {
  scenario::Assembly run(one, sources());
  test::Recording rows;
  run.coordinator().observe(&rows);
  run.initialize();
  while (run.coordinator().round()) {
  }
  return rows.rows(subsystem);
}

/// Of x1 at the nodes of a step, beside the exact motion with these constants.
double error_of(const std::string& file, const std::string& how, double step, const Settings& constants) {
  const std::string steps = fmt::format("constants.step={:.17g}", step);
  const auto one = scenario::read(scenes + file, {steps, "connections.reconstruction=" + how});
  Settings settings = constants;
  settings.push_back(steps), settings.push_back(fmt::format("span.stop={}", one.stop));
  const auto found = rows_of(one, 0), exact = rows_of(scene("oscillator/exact.toml", settings), 0);
  EXPECT_EQ(found.size(), exact.size());
  double most = 0.0;
  for (std::size_t k = 0; k < std::min(found.size(), exact.size()); ++k)
    most = std::max(most, std::abs(found[k].at(Samples::header) - exact[k].at(Samples::header)));
  return most;
}

const Settings precice = {"constants.c1=39.478417604357432",
                          "constants.c2=39.478417604357432",
                          "constants.c=157.91367041742973",
                          "constants.d1=0",
                          "constants.d2=0",
                          "constants.d=0"};
const Settings udc = {"constants.c1=10", "constants.c2=1000", "constants.c=100",
                      "constants.d1=0",  "constants.d2=0",    "constants.d=0",
                      "constants.x1=0",  "constants.v1=100",  "constants.v2=-100"};

/// A polynomial of degree d through samples errs by H^(d + 1); over a half step as well, so the motion does.
TEST(OutsideProblems, HaveTheOrderOfTheirDegree) {
  for (const auto& [file, constants, step] :
       {std::tuple("oscillator/precice.toml", precice, 0.0025), {"oscillator/udc.toml", udc, 0.0005}})
    for (const int degree : {0, 1, 2, 3}) {
      const std::string how = "lagrange" + std::to_string(degree);
      const double order =
          std::log2(error_of(file, how, step, constants) / error_of(file, how, 0.5 * step, constants));
      EXPECT_NEAR(order, degree + 1.0, 0.2) << file << ' ' << how;
    }
}

/// Without dampers nothing changes it, and z(t) is z(0) moved by an orthogonal matrix in its metric.
TEST(OutsideProblems, TheExactMotionKeepsItsEnergy) {
  Settings settings = udc;
  settings.push_back("constants.step=0.01"), settings.push_back("span.stop=10");
  for (const auto& row : rows_of(scene("oscillator/exact.toml", settings), 0)) {
    const double x1 = row[2], v1 = row[3], x2 = row[4], v2 = row[5];
    const double energy =
        0.5 * (v1 * v1 + v2 * v2 + 10.0 * x1 * x1 + 1000.0 * x2 * x2 + 100.0 * (x1 - x2) * (x1 - x2));
    EXPECT_NEAR(energy, 1e4, 1e-7) << row[0];  // rounding of exp(A t), up to t = 10 s
  }
}

}  // namespace
}  // namespace tandem::outside_problems_tests
