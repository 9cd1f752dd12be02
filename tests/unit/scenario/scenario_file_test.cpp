// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/scenario_file.hpp"
#include "tandem/scenario/sources.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/scenario/traces.hpp"

namespace tandem::scenario {
namespace {

const std::string scene = TANDEM_SOURCE_DIR "/scenarios/motor_crank/scene.toml";

/// What it is to set: keys in one of their orders, or some of them.
std::vector<Setting> random_settings(std::mt19937& random) {
  const std::vector<std::string> schedules = {"slowest-first", "fastest-first", "parallel"};
  const double step = std::uniform_real_distribution(1e-4, 1e-2)(random);
  std::vector<Setting> all = {{"coordination.schedule", schedules[random() % 3]},
                              {"connections.reconstruction", fmt::format("lagrange{}", random() % 5)},
                              {"connections[1].gain", step},
                              {"subsystems.motor.parameters.V", 1.0 / step},
                              {"subsystems.linkage.parameters.step", step},
                              {"record.derivatives", random() % 2 == 0}};
  std::shuffle(all.begin(), all.end(), random);
  all.resize(random() % (all.size() + 1));
  return all;
}

TEST(ScenarioFiles, AreWhatIsReadAnewWithTheSameValues) {
  std::mt19937 random(7);
  const ScenarioFile file(scene, {"span.stop=2"});
  for (int k = 0; k < 500; ++k) {
    const auto settings = random_settings(random);
    std::vector<std::string> overrides = {"span.stop=2"};
    for (const Setting& one : settings) overrides.push_back(text::override_of(one.key, one.value));
    const Scenario own = file.with(settings), anew = read(scene, overrides);
    EXPECT_EQ(own.overrides, anew.overrides);
    ASSERT_EQ(own.values, anew.values) << k;
    EXPECT_EQ(own.subsystems[0].parameters.size(), anew.subsystems[0].parameters.size());
    EXPECT_EQ(own.connections[1].connection.gain, anew.connections[1].connection.gain);
  }
}

TEST(ScenarioFiles, TakeANumberAsTheDoubleThatItIs) {
  const double third = 1.0 / 3.0;
  const auto parameters =
      ScenarioFile(scene).with({{"subsystems.motor.parameters.V", third}}).subsystems[0].parameters;
  EXPECT_EQ(std::get<double>(parameters.back().value), third);
}

TEST(ScenarioFiles, TellWhatTheyDoNotTake) {
  const ScenarioFile file(scene);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument,
                            {"--set coordination.schedule=backwards", "slowest-first"}, [&] {
                              file.with({{"coordination.schedule", "backwards"}});
                            }));
  EXPECT_TRUE(
      test::refuses(ErrorCode::invalid_argument, {"--set coordination.schdule=parallel", "'schdule'"}, [&] {
        file.with({{"coordination.schdule", "parallel"}});
      }));
  EXPECT_EQ(file.with({{"coordination.schedule", "parallel"}}).coordination.schedule,
            Schedule::Kind::parallel);
}

TEST(ScaledSteps, AreThoseOfMechanismAndDiagram) {
  const Builtins builtins = sources();
  Scenario half = read(scene);
  half.coordination.communication_step = 4e-3;
  scale_steps(half, builtins, 0.5);
  EXPECT_EQ(half.coordination.communication_step, 2e-3);
  Assembly assembly(half, builtins);
  assembly.initialize();
  EXPECT_DOUBLE_EQ(assembly.coordinator().own_step(0), 2.5e-4);
  EXPECT_DOUBLE_EQ(assembly.coordinator().own_step(1), 5e-4);
}

TEST(Traces, HaveOwnRowsWithDerivativesAndStepsOfHeldOutputs) {
  const test::Scratch folder;
  const Scenario read_one = read(
      folder.write("s.toml", "[subsystems.controller]\nsource = 'diagram:" TANDEM_SOURCE_DIR
                             "/scenarios/drive/controller.toml'\n"
                             "inputs = { w = { times = [0, 1], values = [0, 10] } }\n[span]\nstop = 0.01\n"));
  const Builtins builtins = sources();
  Assembly assembly(read_one, builtins);
  Traces traces(assembly.topology(), {"controller.i_ref"}, "the run");
  assembly.coordinator().observe(&traces);
  assembly.initialize();
  while (assembly.coordinator().round()) {
  }
  const auto& table = traces.of("controller.i_ref");
  EXPECT_EQ(traces.unit("controller.i_ref"), "A");
  ASSERT_EQ(table.times, (std::vector<double>{0, 2.5e-3, 2.5e-3, 5e-3, 5e-3, 7.5e-3, 7.5e-3, 1e-2, 1e-2}));
  for (std::size_t k = 1; k < table.times.size(); k += 2) {
    EXPECT_EQ(table.columns[0][k], table.columns[0][k - 1]);
    EXPECT_NE(table.columns[0][k + 1], table.columns[0][k]);
  }
  EXPECT_EQ(table.columns[1], std::vector<double>(table.times.size(), 0.0));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument,
                            {"'controller.i_rf'", "did you mean 'controller.i_ref'"},
                            [&] { Traces(assembly.topology(), {"controller.i_rf"}, "the run"); }));
}

}  // namespace
}  // namespace tandem::scenario
