// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Linear models of subsystems that keep their states to themselves, beside what these do and the maps of such that give
// them.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>
#include <random>

#include "hidden.hpp"
#include "long_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/identification/identify.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/identification/surrogate.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::identification_tests {
namespace {

using namespace test;
using identification::identify;
using identification::LinearModel;

std::unique_ptr<Subsystem> hidden(const std::string& source) {
  return std::make_unique<Hidden>(open(source, sources()));
}

/// All values of a row.
identification::Wanted all_of(const SubsystemInfo& info, std::vector<double> inputs, double start = 0.0) {
  identification::Wanted wanted{start, std::move(inputs), {}};
  for (int k = 0; k < info.row_size() - Samples::header; ++k) wanted.values.push_back(k);
  return wanted;
}

/// Rows of 60 own steps on a polynomial of degree 4 in each input.
std::vector<double> rows_of(Subsystem& subsystem, double start, const std::vector<double>& inputs) {
  constexpr std::int64_t steps = 60;
  std::vector<double> memory(static_cast<std::size_t>((steps + 2) * subsystem.info().row_size()));
  Samples y(memory.data(), subsystem.info().row_size(), steps + 2);
  const Clock clock = subsystem.initialize(start, 1e9, inputs, y);
  const double h = clock.next_time - clock.time;
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    pieces.push_back(
        {std::numeric_limits<double>::infinity(), start, {inputs[i], sign * 0.3, 0.2, -sign * 0.1, 0.05}});
  }
  std::vector<Signal> u;
  for (const Segment& s : pieces) u.emplace_back(&s, 1, 4);
  subsystem.advance(start + (steps + 0.5) * h, false, u, y);
  memory.resize(static_cast<std::size_t>(y.size() * subsystem.info().row_size()));
  return memory;
}

/// Rows of all subsystems of a run.
std::vector<test::Recording::Rows> recorded(const scenario::Scenario& one, const Builtins& builtins) {
  scenario::Assembly run(one, builtins);
  test::Recording rows;
  run.coordinator().observe(&rows);
  run.coordinator().run();
  return rows.all();
}

struct Case {
  std::string source;
  std::vector<double> inputs;
  int order;
};

TEST(Identification, ALinearModelGoesOnAsWhatItIsOf) {
  const std::vector<Case> cases = {
      {"builtin:two_mass.fast?frequency_ratio=25", {0.3}, 2},
      {"builtin:two_mass.slow?frequency_ratio=25", {0.3}, 2},
      {"builtin:two_mass.slow?frequency_ratio=25&reuse_acceleration=true", {0.3}, 3},
      {"builtin:two_mass.fast_force?frequency_ratio=7", {-0.2}, 2},
      {"builtin:two_mass.slow_force?frequency_ratio=7", {0.1}, 2},
      {"builtin:two_mass.fast_force?frequency_ratio=7&carried_mass=0.5", {0.1, 0.2}, 2},
      {"builtin:two_mass.both?frequency_ratio=7", {}, 4},
      {"builtin:oscillator.side1?x=1&damping=0.2&step=0.1", {0.5}, 2},
      {"builtin:oscillator.side2?x=1&damping=0.2&step=0.3", {0.5, -0.1}, 2}};
  for (const auto& [source, inputs, order] : cases) {
    const auto of = hidden(source);
    const LinearModel model = identify(*of, all_of(of->info(), inputs));
    EXPECT_TRUE(model.linear) << source;
    EXPECT_EQ(model.order(), order) << source;
    EXPECT_LT(model.residual, 1e-9) << source;
    const auto surrogate = make_surrogate(model, of->info());
    const auto expected = rows_of(*of, 0.0, inputs), found = rows_of(*surrogate, 0.0, inputs);
    ASSERT_EQ(found.size(), expected.size()) << source;
    double most = 0.0, size = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k)
      most = std::max(most, std::abs(found[k] - expected[k])), size = std::max(size, std::abs(expected[k]));
    EXPECT_LT(most, 1e-9 * size) << source;
  }
}

/// By pairing each with the nearest, but for those near 0: samples that nothing reads any more have many of these, which
/// rounding spreads.
double farthest(const Eigen::VectorXcd& of, const Eigen::VectorXcd& among) {
  double most = 0.0;
  for (const auto& a : of) {
    if (std::abs(a) < 0.1) continue;
    double nearest = 1e300;
    for (const auto& b : among) nearest = std::min(nearest, std::abs(a - b));
    most = std::max(most, nearest);
  }
  return most;
}

TEST(Identification, TheMapOfHiddenSubsystemsIsThatOfOpenOnes) {
  const Builtins all_hidden = hiding(sources(), {"two_mass.fast", "two_mass.slow"});
  const Builtins one_hidden = hiding(sources(), {"two_mass.fast"});
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* how : {"lagrange0", "lagrange3", "hermite", "least_squares2_3"})
      for (const double ratio : {1.5, 7.0, 25.0}) {
        const auto one =
            scene("two_mass/two_mass.toml", {"parameters.frequency_ratio=" + std::to_string(ratio),
                                             std::string("coordination.schedule=") + schedule,
                                             std::string("connections.reconstruction=") + how});
        const Eigen::VectorXcd exact = stability::super_step(one, sources()).map.eigenvalues();
        for (const Builtins* which : {&all_hidden, &one_hidden}) {
          const SuperStep found = stability::super_step(one, *which);
          ASSERT_FALSE(found.identified.empty());
          double residual = 1e-12;
          for (const auto& i : found.identified) residual = std::max(residual, i.residual);
          EXPECT_TRUE(found.linear);
          EXPECT_LT(residual, 1e-9);
          EXPECT_LT(std::abs(found.radius() - exact.cwiseAbs().maxCoeff()), 1e-9)
              << schedule << ' ' << how << ' ' << ratio;
          EXPECT_LT(farthest(exact, found.map.eigenvalues()), 1e-7) << schedule << ' ' << how << ' ' << ratio;
        }
      }
}

TEST(Identification, ModesOfHiddenSubsystemsAreThoseOfTheEquations) {
  const auto found = stability::stability(scene("two_mass/two_mass.toml", {}),
                                          hiding(sources(), {"two_mass.fast", "two_mass.slow"}));
  ASSERT_EQ(found.modes.size(), 2U);
  EXPECT_NEAR(found.modes[0].frequency, 1.0, 1e-3);  // the integrator's own error stays
  EXPECT_NEAR(found.modes[1].frequency, 1.0 / 25.0, 1e-3);
}

/// Gives other numbers at each step, the same in each run.
class Noise {
 public:
  SubsystemInfo info() const { return {"noise", {{"u", ""}}, {{"y", ""}}, {}, {}}; }
  double own_step() const { return 0.1; }
  void start(double, std::span<const double>) { random_.seed(25), step({}, {}); }
  void step(const OwnStep&, std::span<const Signal>) {
    y_ = std::uniform_real_distribution<double>(-1.0, 1.0)(random_);
  }
  void outputs(double* y) const { *y = y_; }

 private:
  std::mt19937_64 random_;
  double y_ = 0.0;
};

TEST(Identification, TheResidualTellsWhereNoLinearModelIs) {
  FixedStep<Noise> noise{Noise{}};
  EXPECT_GT(identify(noise, all_of(noise.info(), {0.0})).residual, 0.01);
}

/// Of sides that cut no step. Values by the largest that each is in it.
TEST(Identification, ASuperStepOfModelsIsThatOfTheSubsystemsToTenTimesTheResidual) {
  for (const double ratio : {2.0, 7.0, 25.0})
    for (const char* how : {"lagrange0", "lagrange3", "hermite"}) {
      auto one = scene("two_mass/two_mass.toml", {"parameters.frequency_ratio=" + std::to_string(ratio),
                                                  std::string("connections.reconstruction=") + how});
      one.stop = one.start + stability::super_step(one, sources()).period;
      identification::Models models;
      const auto expected = recorded(one, sources()), found = recorded(one, models.replacing(sources()));
      double residual = 1e-12;  // what rounding leaves of the responses themselves
      for (const auto& stand : models.stands()) residual = std::max(residual, stand.residual);
      for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t k = 2; k < expected[i][0].size(); ++k) {
          double off = 0.0, size = 0.0;
          for (std::size_t row = 0; row < expected[i].size(); ++row)
            off = std::max(off, std::abs(expected[i][row][k] - found[i][row][k])),
            size = std::max(size, std::abs(expected[i][row][k]));
          EXPECT_LE(off, 10.0 * residual * size) << ratio << ' ' << how << ' ' << i << ' ' << k;
        }
    }
}

/// Of a spring's force, which follows its input at once, rk4 knows nothing at a quarter of a step: what is left there is
/// rounding of the force, and no response.
TEST(Identification, RoundingOfWhatFollowsAtOnceIsNoResponse) {
  const Scratch folder;
  for (const char* start : {"0", "0.0099", "0.01", "0.02"}) {
    const auto file = folder.write(
        "spring.toml", std::string("[inputs]\nx = { unit = 'm' }\n[blocks]\n"
                                   "F = { kind = 'sum', inputs = ['x', 'y'], gains = [60e3, -60e3] }\n"
                                   "a = { kind = 'sum', inputs = ['F', 'v'], gains = [0.0125, -2.5] }\n"
                                   "v = { kind = 'integrator', input = 'a' }\n"
                                   "y = { kind = 'integrator', input = 'v', initial = ") +
                           start + " }\n[outputs]\nF = { unit = 'N' }\n");
    const auto spring = open("diagram:" + file.string() + "?step=1e-3", sources());
    const LinearModel model = identify(*spring, all_of(spring->info(), {0.01}));
    EXPECT_EQ(model.order(), 2) << start;
    EXPECT_LT(model.residual, 1e-9) << start;
  }
}

TEST(Identification, WhatCantBeFoundIsNamed) {
  const auto refused = [](const std::string& source, const std::vector<double>& inputs,
                          const std::string& why) {
    const auto of = open(source, sources());
    return refuses(ErrorCode::not_supported, {of->info().name, why},
                   [&] { identify(*of, all_of(of->info(), inputs)); });
  };
  const Scratch folder;
  const auto file = folder.write("two.toml",
                                 "[inputs]\nu = { unit = 'm' }\n[outputs]\ny = { unit = 'm' }\n[blocks]\n"
                                 "a = { kind = 'sample', input = 'u', period = 0.1 }\nb = { kind = 'sample', "
                                 "input = 'a', period = 0.15 }\n"
                                 "y = { kind = 'sum', inputs = ['a', 'b'] }\n");
  EXPECT_TRUE(refused("diagram:" + file.string(), {0.0}, "acts at instants that are not equally far apart"));
}

/// What a subsystem gives at 80 instants, on inputs by chance.
std::vector<double> samples_of(Subsystem& subsystem, double u0) {
  std::mt19937 random(3);
  std::vector<double> all, row(static_cast<std::size_t>(subsystem.info().row_size()));
  Samples first(row.data(), subsystem.info().row_size(), 1);
  Clock clock = subsystem.initialize(0.0, 1e9, std::span(&u0, 1), first);
  all.push_back(first.values(0)[0]);
  for (int k = 0; k < 80; ++k) {
    const double u = std::uniform_real_distribution(-5.0, 5.0)(random);
    double y = 0.0;
    clock = subsystem.sample(clock.next_time, SamplePart::both, std::span(&u, 1), std::span(&y, 1));
    all.push_back(y), all.push_back(clock.next_time);
  }
  return all;
}

/// A diagram's first instant is a period late, and what it starts with depends on its input.
TEST(Identification, AModelOfASampledOneGivesTheSameAtEachInstant) {
  const std::string gains = "?kp=7&ki=87.5&set=10&T=2.5e-3";
  for (const std::string& source : {"diagram:" + scenes + "drive/controller.toml",
                                    "lib:" TANDEM_FILE_LIBRARIES "/drive_controller.so" + gains}) {
    const auto real = open(source, sources());
    const auto model = identify(*real, all_of(real->info(), {3.0}));
    EXPECT_EQ(model.order(), 1) << source;
    const auto surrogate = identification::make_surrogate(model, real->info());
    EXPECT_EQ(surrogate->info().abilities.sampled, true);
    const auto expected = samples_of(*real, 3.0), found = samples_of(*surrogate, 3.0);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_NEAR(found[k], expected[k], 1e-9 * (1.0 + std::abs(expected[k]))) << source << ' ' << k;
  }
}

}  // namespace
}  // namespace tandem::identification_tests
