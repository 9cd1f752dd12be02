// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The first scene of two physics: the linkage driven by the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "engine_linkage/monolithic.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

const std::filesystem::path scene_folder = TANDEM_SOURCE_DIR "/scenarios/engine_linkage";

/// The bar's speed at times that ascend, by CVODE at 1e-10 on the equation of one degree of freedom.
std::vector<double> exact_speed(const std::vector<double>& times) {
  const auto program =
      engine::compile(engine_linkage::monolithic(engine::read_diagram(scene_folder / "engine.toml"), 1));
  engine::Simulation run(
      program, nullptr,
      engine::make_integrator(
          {.name = "cvode_adams", .adaptive = {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12}}));
  run.start(0.0);
  std::vector<double> speeds;
  for (const double t : times) {
    while (run.time() < t) run.step(t);
    speeds.push_back(run.output(static_cast<int>(program.outputs.size()) - 1));
  }
  return speeds;
}

/// The speeds printed in the specification of the scene.
TEST(EngineLinkage, TheOneDegreeOfFreedomRunsAtThePrintedSpeeds) {
  const auto w = exact_speed({1.9, 8.9, 13.9, 19.9, 24.9, 29.9});
  const double printed[] = {28.0, 16.6, 35.4, 12.4, 24.8, 10.2};
  for (std::size_t k = 0; k < w.size(); ++k) EXPECT_NEAR(w[k], printed[k], 0.1) << k;
}

TEST(EngineLinkage, CoupledItStaysNearTheTruth) {
  const test::Scratch scratch;
  const auto said =
      test::tandem(scratch, {"run", (scene_folder / "engine_linkage.toml").string(), "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table = text::TimeTable::read(scratch.path() / "o");
  const auto column =
      std::find(table.names.begin(), table.names.end(), "linkage.speed") - table.names.begin();
  const auto exact = exact_speed(table.times);
  double worst = 0.0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    worst = std::max(worst, std::abs(table.columns[static_cast<std::size_t>(column)][k] - exact[k]));
  EXPECT_LT(worst, 0.05);
  RecordProperty("largest_difference", std::to_string(worst));
}

}  // namespace
}  // namespace tandem
