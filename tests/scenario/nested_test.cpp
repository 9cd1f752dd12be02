// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A scenario as one subsystem, "scenario:FILE".
#include "tandem/scenario/nested.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "command.hpp"
#include "contract_suite.hpp"
#include "nested_open.hpp"
#include "nested_scene.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "sources/all.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::test {
namespace {

/// By time, the last row there of each of its subsystems.
std::map<double, std::map<std::string, double>> rows_of(const std::string& file,
                                                        const std::vector<std::string>& overrides) {
  const scenario::Scenario scenario = scenario::read(file, overrides);
  scenario::Assembly assembly(scenario, all_sources());
  Recording recording;
  assembly.coordinator().observe(&recording);
  assembly.coordinator().run();
  std::map<double, std::map<std::string, double>> all;
  for (int i = 0; i < assembly.topology().size(); ++i) {
    const auto names = assembly.topology().output_names(i);
    for (const auto& row : recording.rows(i))
      for (std::size_t k = 0; k < names.size(); ++k) all[row[0]][names[k]] = row[Samples::header + k];
  }
  return all;
}

/// But for the start and the end, where a run tells no jump.
void expect_the_scenario_itself(const std::string& file, double stop, std::vector<std::string> overrides) {
  SCOPED_TRACE(file);
  overrides.push_back("span.stop=" + std::to_string(stop));
  const auto one = nested(file, overrides);
  const Recording rows = alone(*one, stop);
  auto expected = rows_of(file, overrides);
  const std::vector<Port>& ports = one->info().outputs;
  std::size_t compared = 0;
  for (const auto& row : rows.rows(0))
    for (std::size_t k = 0; k < ports.size(); ++k)
      if (const auto it = expected[row[0]].find(ports[k].name);
          row[0] > 0.0 && row[0] < stop && it != expected[row[0]].end()) {
        EXPECT_EQ(row[Samples::header + k], it->second) << ports[k].name << " at " << row[0];
        ++compared;
      }
  EXPECT_GT(compared, ports.size() * rows.rows(0).size() / 2);
}

TEST(NestedScenario, IsTheScenarioItselfAtTheNodesOfItsSlowest) {
  const Scratch folder;
  write_plant(folder);
  const std::string scenes = TANDEM_SOURCE_DIR "/scenarios/";
  const std::vector<std::string> cold = {"coordination.start=cold"};
  expect_the_scenario_itself(place(folder, "drive.toml"), 2.0, cold);
  expect_the_scenario_itself(scenes + "chains/chains.toml", 10.0, cold);
  expect_the_scenario_itself(scenes + "motor_crank/scene.toml", 0.5, cold);
  expect_the_scenario_itself(scenes + "split_pendulum/split_pendulum.toml", 0.2, cold);
  expect_the_scenario_itself(scenes + "engine_linkage/engine_linkage.toml", 0.5, cold);
  for (const char* schedule : {"fastest-first", "parallel"})
    expect_the_scenario_itself(place(folder, "drive.toml"), 1.0,
                               {cold[0], std::string("coordination.schedule=") + schedule});
}

/// From x = 1, 0, 0 at rest, between walls.
Eigen::Vector3d right_masses(double t) {
  Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
  a.topRightCorner<3, 3>().setIdentity();
  a.bottomLeftCorner<3, 3>() << -7.0, 3.0, 0.0, 3.0 / 2.0, -8.0 / 2.0, 5.0 / 2.0, 0.0, 5.0 / 1.5, -7.0 / 1.5;
  Eigen::Matrix<double, 6, 1> start = Eigen::Matrix<double, 6, 1>::Zero();
  start[0] = 1.0;
  return ((a * t).exp() * start).head<3>();
}

/// The first mass beside a scenario of two others, all of step h or h / 2.
double error_of_three(const Scratch& folder, double h, const std::string& schedule) {
  const std::string step = "step=" + std::to_string(h);
  const auto one = open("diagram:" + place(folder, "mass.toml") + "?x0=1&" + step, all_sources());
  const auto pair = nested(place(folder, "pair.toml") + "?h=" + std::to_string(h));
  RunBench bench;
  bench.add("one", *one).add("pair", *pair).schedule(schedule);
  bench.connect("pair.two.x", "one.w", "lagrange3").connect("one.x", "pair.two.u", "lagrange3");
  bench.topology.set_start("one.u", 0.0);
  const Recording& r = bench.run(4.0);
  const Eigen::Vector3d right = right_masses(4.0);
  return std::abs(r.rows(0).back()[2] - right[0]) + std::abs(r.rows(1).back()[2] - right[1]) +
         std::abs(r.rows(1).back()[3] - right[2]);
}

/// Degree 3 within and without, of masses by the classical Runge-Kutta method.
TEST(NestedScenario, CouplesInOrder4) {
  const Scratch folder;
  write_three_masses(folder);
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    const double coarse = error_of_three(folder, 0.04, schedule),
                 fine = error_of_three(folder, 0.01, schedule);
    EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 4.0, 0.3) << schedule << " " << fine;
  }
}

TEST(NestedScenario, ANestedOneOfNestedOnesIsTheSame) {
  const Scratch folder;
  write_three_masses(folder);
  folder.write(
      "outer.toml",
      "[subsystems.in]\nsource = 'scenario:pair.toml'\nparameters = { h = 0.02 }\n[span]\nstop = 4\n");
  const auto one = nested(place(folder, "pair.toml") + "?h=0.02"),
             other = nested(place(folder, "outer.toml"));
  EXPECT_TRUE(same_bits(alone(*one, 2.0).all(), alone(*other, 2.0).all()));
  EXPECT_EQ(other->info().inputs.at(0).name, "in.two.u");
  EXPECT_EQ(other->info().outputs.at(1).name, "in.three.x");
}

TEST(NestedScenario, HasTheInputsThatNothingGivesAndTheOutputsThatItRecords) {
  const Scratch folder;
  write_plant(folder);
  const SubsystemInfo info = nested(place(folder, "drive.toml"))->info();
  ASSERT_EQ(info.inputs.size(), 1U);
  EXPECT_EQ(info.inputs[0].name, "actuator.r");
  EXPECT_EQ(info.inputs[0].unit, "m");
  EXPECT_EQ(info.inputs[0].start, 0.2);
  std::string outputs;
  for (const Port& port : info.outputs) outputs += port.name + (port.held ? " held; " : "; ");
  EXPECT_EQ(outputs, "plant.x; plant.a; actuator.T; damper.u held; ");
  ASSERT_EQ(info.feedthrough.size(), 2U);
  EXPECT_EQ(info.feedthrough[0].output, 1);
  EXPECT_EQ(info.feedthrough[1].output, 2);
  EXPECT_TRUE(info.abilities.lands && info.abilities.restarts && info.abilities.serializes_state);
}

/// T = late + 5 (r - x), m a = T + d - 30 x - 0.6 v.
TEST(NestedScenario, WhatFollowsAnInputAtOnceJumpsWithItThroughAllMembers) {
  const Scratch folder;
  write_plant(folder);
  const auto one = nested(place(folder, "drive.toml"));
  const auto r = std::make_shared<TimeSeries>("r", std::vector{0.0, 0.503, 2.0}, std::vector{0.2, 1.0, 1.0},
                                              TimeSeries::How{TimeSeries::Between::hold, {}});
  RunBench bench;
  bench.add("all", *one).topology.drive("all.actuator.r", r);
  const auto& rows = bench.run(1.0).rows(0);
  std::size_t jumps = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (rows[k][0] != rows[k - 1][0]) continue;
    ++jumps;
    EXPECT_EQ(rows[k][0], 0.503);
    EXPECT_EQ(rows[k][2], rows[k - 1][2]);
    EXPECT_NEAR(rows[k][3] - rows[k - 1][3], 5.0 * 0.8 / 2.0, 1e-7);  // the plant had extrapolated T
    EXPECT_NEAR(rows[k][4] - rows[k - 1][4], 5.0 * 0.8, 1e-12);
  }
  EXPECT_EQ(jumps, 1U);
}

TEST(NestedScenario, HasTheOwnStepOfItsSlowestFromAnyTime) {
  const Scratch folder;
  write_plant(folder);
  for (const char* start : {"0", "1000", "-7.3", "1e6"}) {
    const double t = std::stod(start);
    const auto one = nested(place(folder, "drive.toml"), {std::string("span.stop=") + std::to_string(t + 1.0),
                                                          std::string("span.start=") + start});
    RunBench bench;
    bench.add("all", *one);
    const auto& rows = bench.run(t + 1.0, t).rows(0);
    ASSERT_EQ(rows.size(), 251U) << start;
    for (std::size_t k = 0; k + 1 < rows.size(); ++k)
      EXPECT_EQ(rows[k][0], t + static_cast<double>(k) * 0.004);
  }
}

/// And states take no more room as it runs on.
TEST(NestedScenario, GoesOnRightFromAStateAfterACallThatFailed) {
  const Scratch folder;
  write_plant(folder);
  const auto one = nested(place(folder, "drive.toml"));
  const auto stride = one->info().row_size();
  std::vector<double> memory(static_cast<std::size_t>(stride) * 600), u0 = {0.2};
  const auto go = [&](double t, double r) {
    const Segment piece{t, 0.0, {r}};
    const Signal u(&piece, 1, 0);
    Samples y(memory.data(), stride, 600);
    one->advance(t, true, {&u, 1}, y);
    const auto values = y.values(y.size() - 1);
    return std::vector<double>(values.begin(), values.end());
  };
  Samples first(memory.data(), stride, 1);
  one->initialize(0.0, 100.0, u0, first);
  go(0.1, 0.2);
  const StateId state = one->save_state();
  const std::size_t size = one->serialize_state(state).size();
  const auto expected = go(0.3, 0.5);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"block 'late'"}, [&] { go(0.4, 1e308); }));
  one->restore_state(state);
  EXPECT_EQ(go(0.3, 0.5), expected);
  for (int k = 4; k < 200; ++k) go(0.1 * k, k % 3);
  EXPECT_LT(one->serialize_state(one->save_state()).size(), size + 20000);
}

/// [span] stop = 2, and data without `beyond`.
TEST(NestedScenario, IsNotRunPastWhatIsKnownOfIt) {
  const Scratch folder;
  write_plant(folder);
  folder.write("d.toml",
               "[subsystems.a]\nsource = 'diagram:damper.toml'\n[subsystems.a.inputs]\n"
               "v = { times = [0, 1], values = [0, 1] }\n[span]\nstop = 1\n");
  const auto other = nested(place(folder, "d.toml"));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"input a.v is driven by", "from 0 to 1 s", "to 1.5 s"},
                      [&] { alone(*other, 1.5); }));
  std::vector<double> memory(static_cast<std::size_t>(other->info().row_size()) * 99);
  Samples first(memory.data(), other->info().row_size(), 1), y(memory.data(), other->info().row_size(), 99);
  other->initialize(0.0, std::numeric_limits<double>::infinity(), {}, first);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'d' is run to t = ", "up to 1 s", "1000 times its span"},
                      [&] { other->advance(1.5, true, {}, y); }));
}

Opener opener(const char* file) {
  return [file]() -> std::unique_ptr<Subsystem> {
    const Scratch folder;
    write_three_masses(folder);
    write_plant(folder);
    return nested(place(folder, file));
  };
}
INSTANTIATE_TEST_SUITE_P(Nested, SubsystemContract,
                         testing::Values(ContractCase{"pair", opener("pair.toml")},
                                         ContractCase{"pair later", opener("pair.toml"), -7.3},
                                         ContractCase{"drive", opener("drive.toml")}),
                         contract_name);

TEST(NestedScenario, WithoutInputsHasNoStabilityThatCouldBeTold) {
  const Scratch folder;
  folder.write("decay.toml",
               "[blocks]\nx = { kind = 'lag', input = 1, time = 1 }\n[outputs]\nx = { unit = '1' }\n[run]\n"
               "stop = 1\nstep = 0.01\n");
  folder.write("inner.toml", "[subsystems.a]\nsource = 'diagram:decay.toml'\n[span]\nstop = 1\n");
  folder.write("outer.toml", "[subsystems.b]\nsource = 'scenario:inner.toml'\n[span]\nstop = 1\n");
  const Said said = tandem(folder, {"stability", "outer.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "outer.toml: no subsystem gives its states")) << said.err;
}

TEST(NestedScenario, RunsFromTheCommandLineAndOverACheckpoint) {
  const Scratch folder;
  write_plant(folder);
  folder.write("outer.toml", "[subsystems.drive]\nsource = 'scenario:drive.toml'\n[span]\nstop = 1\n");
  EXPECT_EQ(tandem(folder, {"validate", "outer.toml"}).status, 0);
  ASSERT_EQ(tandem(folder, {"run", "outer.toml", "--output", "whole"}).status, 0);
  ASSERT_EQ(tandem(folder, {"run", "outer.toml", "--output", "r", "--checkpoint-every", "0.3"}).status, 0);
  ASSERT_EQ(tandem(folder, {"run", "outer.toml", "--output", "r", "--resume", "r/checkpoint"}).status, 0);
  EXPECT_EQ(read_text(folder.path() / "r/results.csv"), read_text(folder.path() / "whole/results.csv"));
  folder.write("damper.toml", read_text(folder.path() / "damper.toml") + "# another one\n");
  const Said said = tandem(folder, {"run", "outer.toml", "--output", "r", "--resume", "r/checkpoint"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "another")) << said.err;
}

}  // namespace
}  // namespace tandem::test
