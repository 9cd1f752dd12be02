// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The map of a super-step against runs of the same scenario: step by step, and how it grows in the long run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "command.hpp"
#include "recording.hpp"
#include "refusal.hpp"
#include "sources/all.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_tests {
namespace {

using Eigen::VectorXd;
using stability::Coordinate;
using stability::SuperStep;

const std::string scenes = TANDEM_SOURCE_DIR "/scenarios/";

using Settings = std::vector<std::string>;

scenario::Scenario scene(const std::string& file, const Settings& settings) {
  scenario::Scenario one = scenario::read(scenes + file, settings);
  one.coordination.start = StartKind::cold;
  one.coordination.diverged_beyond = std::numeric_limits<double>::infinity();
  return one;
}

const Builtins& sources() {
  static const Builtins all = all_sources();
  return all;
}

/// A run of so many super-steps, of subsystems whose states are outputs too, by the same names.
class LongRun {
 public:
  LongRun(scenario::Scenario scenario, const SuperStep& step, int super_steps) : step_(step) {
    scenario.stop = scenario.start + super_steps * step.period;
    scenario::Assembly run(scenario, sources());
    for (int i = 0; i < run.topology().size(); ++i) outputs_.push_back(run.topology().output_names(i));
    run.coordinator().observe(&rows_);
    run.initialize();
    while (run.coordinator().round()) {
    }
  }

  /// What stands after k super-steps.
  VectorXd at(int k) const {
    VectorXd z(static_cast<Eigen::Index>(step_.coordinates.size()));
    for (std::size_t i = 0; i < step_.coordinates.size(); ++i) {
      const Coordinate& c = step_.coordinates[i];
      const auto& rows = rows_.rows(c.subsystem);
      const std::size_t newest = row_at(rows, k * step_.period);
      const auto& names = outputs_[static_cast<std::size_t>(c.subsystem)];
      const auto index = c.age < 0 ? std::find(names.begin(), names.end(), c.name) - names.begin() : c.index;
      z[static_cast<Eigen::Index>(i)] = rows[newest - static_cast<std::size_t>(std::max(c.age, 0))].at(
          static_cast<std::size_t>(Samples::header + index));
    }
    return z;
  }

 private:
  static std::size_t row_at(const test::Recording::Rows& rows, double t) {
    const auto near = [](const auto& row, double time) { return row[0] < time; };
    const auto it = std::lower_bound(rows.begin(), rows.end(), t - 1e-9 * std::max(1.0, t), near);
    EXPECT_TRUE(it != rows.end() && std::abs((*it)[0] - t) < 1e-9 * std::max(1.0, t)) << "no row at " << t;
    return static_cast<std::size_t>(it - rows.begin());
  }

  const SuperStep& step_;
  test::Recording rows_;
  std::vector<std::vector<std::string>> outputs_;
};

TEST(Stability, TheMapMovesWhatStandsInARunOfTwoMassesAsTheRunDoes) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* how :
         {"lagrange0", "lagrange1", "lagrange3", "lagrange4", "hermite", "least_squares2_3"})
      for (const double ratio : {1.5, 7.0, 25.0}) {
        const auto one =
            scene("two_mass/two_mass.toml", {"parameters.frequency_ratio=" + std::to_string(ratio),
                                             std::string("coordination.schedule=") + schedule,
                                             std::string("connections.reconstruction=") + how});
        const SuperStep step = stability::super_step(one, sources());
        EXPECT_TRUE(step.linear);
        const LongRun run(one, step, 14);
        for (const int k : {10, 12}) {
          const VectorXd from = run.at(k), to = run.at(k + 1);
          EXPECT_LE((step.map * from - to).norm(), 1e-12 * to.norm())
              << schedule << ' ' << how << ' ' << ratio;
        }
      }
}

TEST(Stability, TheMapKnowsMeansMatchedHoldsMemoryAndDelay) {
  const std::vector<std::pair<std::string, Settings>> all = {
      {"two_mass/two_mass.toml",
       {"coordination.schedule=fastest-first", "connections[1].reconstruction=mean"}},
      {"two_mass/two_mass.toml", {"connections.reconstruction=matched_hold"}},
      {"two_mass/staggered.toml", {}},
      {"two_mass/force_memory.toml", {}},
      {"two_mass/force_delay.toml", {}}};
  for (const auto& [file, settings] : all) {
    const auto one = scene(file, settings);
    const SuperStep step = stability::super_step(one, sources());
    const LongRun run(one, step, 14);
    const VectorXd from = run.at(11), to = run.at(12);
    EXPECT_LE((step.map * from - to).norm(), 1e-12 * to.norm()) << file;
  }
}

/// spring: what is as long as it; blocks: more of them.
std::string diagram(double stiffness, const std::string& spring = "x", const std::string& blocks = "") {
  return "[inputs]\nF = { unit = \"1\" }\n[blocks]\nv = { kind = \"integrator\", input = \"a\" }\n"
         "x = { kind = \"integrator\", input = \"v\", initial = 1 }\n" +
         blocks + "a = { kind = \"sum\", inputs = [\"F\", \"" + spring + "\", \"v\"], gains = [1, " +
         std::to_string(-stiffness) + ", -0.1] }\n[outputs]\nx = { unit = \"1\" }\nv = { unit = \"1\" }\n";
}

scenario::Scenario diagrams(const test::Scratch& folder, const std::string& soft) {
  folder.write("soft.toml", soft);
  folder.write("stiff.toml", diagram(9.0));
  return scenario::read(folder.write("s.toml", R"toml([subsystems.soft]
source = "diagram:soft.toml"
parameters = { step = 0.06 }
[subsystems.stiff]
source = "diagram:stiff.toml"
parameters = { step = 0.02 }
[[connections]]
from = "soft.x"
to = "stiff.F"
reconstruction = "lagrange2"
[[connections]]
from = "stiff.v"
to = "soft.F"
reconstruction = "lagrange2"
[coordination]
start = "cold"
[span]
stop = 1
)toml"));
}

TEST(Stability, DiagramsOfContinuousBlocksGiveTheirStates) {
  const test::Scratch folder;
  const auto one = diagrams(folder, diagram(1.0));
  const SuperStep step = stability::super_step(one, sources());
  EXPECT_TRUE(step.linear);
  const LongRun run(one, step, 14);
  const VectorXd from = run.at(11), to = run.at(12);
  EXPECT_LE((step.map * from - to).norm(), 1e-12 * to.norm());
  const auto found = stability::stability(one, sources());
  ASSERT_EQ(found.modes.size(), 2U);
  Eigen::Matrix4d rates;  // soft.x, soft.v, stiff.x, stiff.v
  rates << 0, 1, 0, 0, -1, -0.1, 0, 1, 0, 0, 0, 1, 1, 0, -9, -0.1;
  const Eigen::Vector4cd exact = rates.eigenvalues();
  for (const auto& mode : found.modes) {
    double nearest = 1.0;
    for (const auto& p : exact)
      nearest = std::min(nearest, std::abs(std::abs(p.imag()) / (2.0 * std::numbers::pi) - mode.frequency) +
                                      std::abs(-p.real() / std::abs(p) - mode.damping));
    EXPECT_LT(nearest, 1e-7);
  }
}

TEST(Stability, DiagramsThatRememberMoreAreNamed) {
  const test::Scratch folder;
  const auto one =
      diagrams(folder, diagram(1.0, "late", "late = { kind = \"delay\", input = \"x\", delay = 0.1 }\n"));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"subsystem 'soft'", "states as numbers"},
                            [&] { stability::super_step(one, sources()); }));
}

/// A scene of two oscillators of all kinds.
Settings any_oscillators(std::mt19937_64& random) {
  const auto between = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto one_of = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  const auto text = [](const std::string& key, double value) {
    return key + "=" + fmt::format("{:.17g}", value);
  };
  Settings all = {text("constants.m2", std::exp(between(-2.0, 2.0))),
                  text("constants.c2", std::exp(between(-2.0, 2.0))),
                  text("constants.c", std::exp(between(-2.0, 2.0))),
                  text("constants.d1", between(0.0, 0.3)),
                  text("constants.d2", between(0.0, 0.3)),
                  text("constants.d", between(0.0, 0.3)),
                  "connections.reconstruction=lagrange" + std::to_string(one_of(4))};
  const double step = std::exp(between(-2.0, 0.5));
  all.push_back(text("constants.step", step));
  all.push_back(text("subsystems.side2.parameters.step", step / (1 + one_of(5))));
  const char* const schedules[] = {"slowest-first", "fastest-first", "parallel"};
  all.push_back(std::string("coordination.schedule=") + schedules[one_of(3)]);
  return all;
}

/// Growth of a super-step over the second half of a long run, in the logarithm.
double growth_in(const scenario::Scenario& one, const SuperStep& step, double expected) {
  constexpr double most = 300.0;  // in the logarithm: squares stay within a double
  const int length = static_cast<int>(std::clamp(most / std::abs(expected), 40.0, 20000.0)),
            part = length / 4;
  const LongRun run(one, step, length + 1);
  const auto largest = [&](int from) {
    double most = 0.0;
    for (int k = from; k < from + part; ++k) most = std::max(most, run.at(k).norm());
    return std::log(most);
  };
  return (largest(length - part) - largest(length - 2 * part)) / part;
}

TEST(Stability, RandomOscillatorsGrowAndDieOutAsTheRadiusSays) {
  std::mt19937_64 random(25);
  const char* const files[] = {"force_displacement", "displacement_displacement", "force_force"};
  int stable = 0, unstable = 0;
  for (int k = 0; k < 200; ++k) {
    Settings settings = any_oscillators(random);
    const std::string file = files[k % 3];
    if (file == "force_force") settings.back() = "coordination.schedule=parallel";
    const auto one = scene("oscillator/" + file + ".toml", settings);
    const SuperStep step = stability::super_step(one, sources());
    const double expected = std::log(stability::spectral_radius(step.map));
    if (std::abs(expected) < 2e-3) continue;  // as long a run as that takes
    const double found = growth_in(one, step, expected);
    ++(expected > 0.0 ? unstable : stable);
    EXPECT_NEAR(found, expected, 0.01 * std::abs(expected)) << k << ' ' << file << ' ' << listed(settings);
  }
  EXPECT_GT(stable, 40);
  EXPECT_GT(unstable, 40);
}

TEST(Stability, ModesOfTheSystemUndividedAreThoseOfTheEquations) {
  const auto masses = stability::stability(scene("two_mass/two_mass.toml", {}), sources());
  ASSERT_EQ(masses.modes.size(), 2U);
  EXPECT_NEAR(masses.modes[0].frequency, 1.0, 1e-6);
  EXPECT_NEAR(masses.modes[1].frequency, 1.0 / 25.0, 1e-6);
  for (const auto& mode : masses.modes) EXPECT_NEAR(mode.damping, 0.0, 1e-6);
  EXPECT_EQ(masses.mostly(masses.modes[0]), "fast.x1, fast.v1");
  EXPECT_EQ(masses.mostly(masses.modes[1]), "slow.x2, slow.v2");
  // m = c = 1, d = 0.1: x1 + x2 has c and d, x1 - x2 has 3c and 3d
  const auto sides = stability::stability(scene("oscillator/force_displacement.toml", {}), sources());
  ASSERT_EQ(sides.modes.size(), 2U);
  for (const auto& [mode, times] : {std::pair{sides.modes[1], 1.0}, {sides.modes[0], 3.0}}) {
    const double ratio = 0.05 * std::sqrt(times);
    EXPECT_NEAR(mode.frequency, std::sqrt(times * (1.0 - ratio * ratio)) / (2.0 * std::numbers::pi), 1e-7);
    EXPECT_NEAR(mode.damping, ratio, 1e-7);
    EXPECT_NEAR(mode.scheme_frequency, mode.frequency, 1e-3 * mode.frequency);  // ten steps a radian
    EXPECT_GT(mode.likeness, 0.99);
  }
}

/// Both sides are exact and read polynomials, so that is all that detunes: of degree d by H^(d + 1).
TEST(Stability, DetuningAndDampingOfASchemeHaveItsOrder) {
  for (const int degree : {1, 2, 3}) {
    std::vector<double> far;
    for (const double step : {0.05, 0.025}) {
      const auto found =
          stability::stability(scene("oscillator/force_displacement.toml",
                                     {"constants.step=" + std::to_string(step),
                                      "connections.reconstruction=lagrange" + std::to_string(degree)}),
                               sources());
      const auto& mode = found.modes[0];
      far.push_back(std::hypot(mode.detuning(), mode.scheme_damping - mode.damping));
    }
    EXPECT_NEAR(std::log2(far[0] / far[1]), degree + 1.0, 0.2) << degree;
  }
}

TEST(Stability, WhatHasNoStatesIsNamed) {
  const auto refused = [](const std::string& file, const std::vector<std::string>& words) {
    return test::refuses(ErrorCode::invalid_argument, words,
                         [&] { stability::super_step(scene(file, {}), sources()); });
  };
  EXPECT_TRUE(refused("split_pendulum/split_pendulum.toml", {"subsystem 'upper'", "states as numbers"}));
  EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {"no common period", "1000"}, [] {
    stability::super_step(scene("two_mass/two_mass.toml", {"parameters.frequency_ratio=31.4159265"}),
                          sources());
  }));
}

const std::string study = "scenario = '" + scenes + R"toml(two_mass/two_mass.toml'
[set]
"parameters.frequency_ratio" = "$ratio"
[[tables.t.blocks]]
axes = [{ ratio = [10, 25, 90] }]
[metrics]
spectral_radius = {}
)toml";

TEST(StabilityStudy, HasRadiusDampingAndDetuningWithoutARun) {
  const test::Scratch folder;
  folder.write("s.toml", study + "damping = { state = 'fast.x1' }\ndetuning = {}\n");
  const auto said = test::tandem(folder, {"sweep", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto rows = charts::CsvTable::read(folder.path() / "o/t.csv", {});
  for (std::size_t k = 0; k < 2; ++k) {
    const auto found = stability::stability(
        scene("two_mass/two_mass.toml", {"parameters.frequency_ratio=" + rows[k].text("ratio")}), sources());
    EXPECT_NEAR(rows[k].number("spectral_radius"), found.radius, 1e-14);
    EXPECT_NEAR(rows[k].number("damping"), found.modes[0].scheme_damping - found.modes[0].damping, 1e-12);
    EXPECT_NEAR(rows[k].number("detuning"), found.modes[0].detuning(), 1e-12);
  }
  EXPECT_EQ(rows[2].text("damping"), "");
  EXPECT_EQ(rows[2].text("note"), "the scheme has no mode like that of fast.x1, fast.v1");
}

TEST(StabilityStudy, WrongStatesAreRefused) {
  const test::Scratch folder;
  for (const auto& [metric, why] :
       {std::pair("damping = { state = 'fast.x' }", "state 'fast.x' is not there"),
        std::pair("damping = { mode = 1 }", "metrics.damping.of is missing"),
        std::pair("e = { of = 'fast.x1', state = 'fast.x1' }", "state")}) {
    folder.write("s.toml", study + metric + "\n");
    const auto said = test::tandem(folder, {"sweep", "s.toml", "--output", "x"});
    EXPECT_EQ(said.status, 2) << said.out;
    EXPECT_NE(said.err.find(why), std::string::npos) << said.err;
  }
}

TEST(Stability, LargestStepsAreThoseOfTheSearch) {
  const auto of = [](const std::string& file, const Settings& settings) {
    return stability::largest_step(scene(file, settings), sources());
  };
  const Settings unit = {"constants.step=1",
                         "constants.d1=0.1",
                         "constants.d2=0.1",
                         "constants.d=0.1",
                         "coordination.schedule=parallel",
                         "connections.reconstruction=lagrange0"};
  const auto found = of("oscillator/force_displacement.toml", unit);
  EXPECT_EQ(found.whose, "communication step");
  EXPECT_EQ(found.step, 1.0);
  EXPECT_GT(found.factor, 0.0);
  for (const auto& [times, stable] : {std::pair(0.9999, true), {1.0001, false}}) {
    Settings near = unit;
    near[0] = "constants.step=" + fmt::format("{:.17g}", found.factor * times);
    const double radius = stability::spectral_radius(
        stability::super_step(scene("oscillator/force_displacement.toml", near), sources()).map);
    EXPECT_EQ(radius <= 1.0 + 1e-9, stable) << times;
  }
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'fast'", "no parameter"},
                            [&] { of("two_mass/two_mass.toml", {}); }));
}

TEST(StabilityCommand, TellsRadiusAndModes) {
  const test::Scratch folder;
  const auto said = test::tandem(folder, {"stability", scenes + "two_mass/two_mass.toml"});
  EXPECT_EQ(said.status, 0) << said.err;
  for (const char* words : {"unstable", "super-step: 0.25 s, own steps: fast 25, slow 1",
                            "spectral radius: 1.0000", "fast.x1, fast.v1", "largest stable step: not known"})
    EXPECT_NE(said.out.find(words), std::string::npos) << said.out;
}

}  // namespace
}  // namespace tandem::stability_tests
