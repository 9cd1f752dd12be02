// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Maps of super-steps in which subsystems sample, against matrix exponentials and long runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "long_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/sampled.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_of_samples_tests {
namespace {

using namespace test;
using Eigen::MatrixXd;

struct Gains {
  double k, d, i;  ///< of position, velocity, and the sum of positions
  double period, offset, latency;
};

/// F = -(k x + d v + s), then s becomes s + i T x.
class Controller {
 public:
  explicit Controller(const Gains& gains) : gains_(gains) {}
  SubsystemInfo info() const {
    return {"controller", {{"x", "m"}, {"v", "m/s"}}, {{"F", "N"}}, {{0, 0}, {0, 1}}, {}};
  }
  double own_step() const { return gains_.period; }
  double offset() const { return gains_.offset; }
  double latency() const { return gains_.latency; }
  void start(double, std::span<const double>) { s_ = 0.0; }
  void outputs(double* y) const { *y = -s_; }
  void outputs(double* y, std::span<const double> u) const { *y = -(gains_.k * u[0] + gains_.d * u[1] + s_); }
  void step(const OwnStep& s, std::span<const Signal> u) {
    s_ += gains_.i * gains_.period * u[0].value(s.begin);
  }

 private:
  Gains gains_;
  double s_ = 0.0;
};

Builtins with_controller(const Gains& gains) {
  Builtins all = sources();
  all.models["controller"] = {{}, [gains](const Address&, Parameters&) -> std::unique_ptr<Subsystem> {
                                return std::make_unique<Sampled<Controller>>(Controller(gains));
                              }};
  return all;
}

std::string connection(const std::string& from, const std::string& to, const std::string& more) {
  return "[[connections]]\nfrom = '" + from + "'\nto = '" + to + "'\n" + more + "\n";
}

/// Sides that are exact for held forces; the coupling is a spring of which each gets the force.
scenario::Scenario scene_of(const Scratch& folder, const std::vector<double>& steps, double coupling,
                            const std::string& schedule, double stop) {
  std::string text = "[coordination]\nschedule = '" + schedule + fmt::format("'\n[span]\nstop = {}\n", stop);
  for (std::size_t k = 0; k < steps.size(); ++k)
    text += fmt::format(
        "[subsystems.side{0}]\nsource = 'builtin:oscillator.side1'\nparameters = {{ mass = {1}, stiffness = "
        "{2}, "
        "damping = 0.2, x = 1, step = {3} }}\n",
        k + 1, 1.0 + static_cast<double>(k), 1.0 + 2.0 * static_cast<double>(k), steps[k]);
  text += "[subsystems.control]\nsource = 'builtin:controller'\n" +
          connection("side1.x", "control.x", "reconstruction = 'lagrange2'") +
          connection("side1.v", "control.v", "reconstruction = 'lagrange2'") +
          connection("control.F", "side1.F", steps.size() > 1 ? "add = true" : "");
  for (const auto& [from, to, sign] : {std::tuple{"side2.x", "side1.F", 1},
                                       {"side1.x", "side1.F", -1},
                                       {"side1.x", "side2.F", 1},
                                       {"side2.x", "side2.F", -1}})
    if (steps.size() > 1)
      text += connection(from, to,
                         fmt::format("add = true\ngain = {}\nreconstruction = 'lagrange2'", sign * coupling));
  auto one = scenario::read(folder.write("s.toml", text));
  one.coordination.start = StartKind::cold;
  one.coordination.diverged_beyond = std::numeric_limits<double>::infinity();
  return one;
}

double radius_of(const MatrixXd& map) { return map.eigenvalues().cwiseAbs().maxCoeff(); }

/// From one instant to the next: x, v, s, the force that acts, and the one that is new.
MatrixXd exact_map(const Gains& g) {
  const auto moved = [](double t) {
    MatrixXd rates = MatrixXd::Zero(3, 3);
    rates << 0.0, 1.0, 0.0, -1.0, -0.2, 1.0, 0.0, 0.0, 0.0;
    return MatrixXd((rates * t).exp());
  };
  MatrixXd early = MatrixXd::Identity(5, 5), late = early, swap = early, act = early;
  const MatrixXd a = moved(g.latency), b = moved(g.period - g.latency);
  early.topLeftCorner(2, 2) = a.topLeftCorner(2, 2), early.block(0, 3, 2, 1) = a.block(0, 2, 2, 1);
  swap.row(3) = VectorXd::Unit(5, 4).transpose();
  late.topLeftCorner(2, 2) = b.topLeftCorner(2, 2), late.block(0, 3, 2, 1) = b.block(0, 2, 2, 1);
  act.row(4) << -g.k, -g.d, -1.0, 0.0, 0.0;
  act(2, 0) = g.i * g.period;
  return act * late * swap * early;
}
double exact_radius(const Gains& g) { return radius_of(exact_map(g)); }

TEST(StabilityOfSamples, TheRadiusOfASampledLoopIsThatOfItsMatrixExponentials) {
  std::mt19937_64 random(7);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const double parts[] = {1.0, 0.5, 0.2, 2.0 / 3.0};
  int unstable = 0;
  for (int k = 0; k < 60; ++k) {
    const double period = between(0.1, 1.0);
    const Gains gains{between(0.0, 8.0),
                      between(0.0, 2.0),
                      between(0.0, 2.0),
                      period,
                      k % 3 == 0 ? 0.0 : between(0.0, 2.5) * period,
                      k % 2 == 0 ? 0.0 : between(0.0, 1.0) * period};
    const Scratch folder;
    const auto one =
        scene_of(folder, {parts[k % 4] * period}, 0.0, k % 5 == 0 ? "parallel" : "slowest-first", 5.0);
    const SuperStep step = stability::super_step(one, with_controller(gains));
    EXPECT_TRUE(step.linear);
    const double per_period = std::pow(radius_of(step.map), period / step.period),
                 expected = exact_radius(gains);
    EXPECT_NEAR(per_period, expected, 1e-9 * expected) << k;
    unstable += expected > 1.0;
  }
  EXPECT_GT(unstable, 10);
  EXPECT_LT(unstable, 50);
}

/// Growth of both positions over a super-step, in the second half of a long run.
double growth_in(scenario::Scenario one, const Builtins& all, const SuperStep& step, double expected) {
  const int length = static_cast<int>(std::clamp(200.0 / std::abs(expected), 60.0, 8000.0)),
            part = length / 4;
  one.stop = one.start + length * step.period;
  scenario::Assembly run(one, all);
  test::Recording rows;
  run.coordinator().observe(&rows);
  run.initialize();
  while (run.coordinator().round()) {
  }
  const auto largest = [&](double from, double to) {
    double most = 0.0;
    for (int side = 0; side < 2; ++side)
      for (const auto& row : rows.rows(side))
        if (row[0] > from && row[0] <= to) most = std::max(most, std::abs(row[2]));
    return std::log(most);
  };
  const double end = one.stop, window = part * step.period;
  return (largest(end - window, end) - largest(end - 2.0 * window, end - window)) / part;
}

TEST(StabilityOfSamples, CoupledSidesWithAControllerGrowAsTheRadiusSays) {
  std::mt19937_64 random(11);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const char* const schedules[] = {"slowest-first", "fastest-first", "parallel"};
  int checked = 0;
  for (int k = 0; k < 30; ++k) {
    const double period = between(0.2, 0.8);
    const Gains gains{between(0.0, 6.0),
                      between(0.0, 1.0),
                      between(0.0, 1.0),
                      period,
                      0.0,
                      k % 2 == 0 ? 0.0 : 0.3 * period};
    const auto all = with_controller(gains);
    const Scratch folder;
    const auto one = scene_of(folder, {period / (1 + k % 3), period / (1 + k % 2)}, between(0.2, 2.0),
                              schedules[k % 3], 5.0);
    const SuperStep step = stability::super_step(one, all);
    const double expected = std::log(radius_of(step.map));
    if (std::abs(expected) < 3e-3) continue;  // as long a run as that takes
    ++checked;
    EXPECT_NEAR(growth_in(one, all, step, expected), expected, 0.02 * std::abs(expected) + 1e-4) << k;
  }
  EXPECT_GT(checked, 20);
}

/// The same controller in C++ and as a diagram, which begins one period later and whose start depends on its input.
TEST(StabilityOfSamples, TheDriveHasTheSameRadiusWithEitherController) {
  const auto radius = [](const Settings& settings) {
    return radius_of(stability::super_step(scene("drive/drive_libraries.toml", settings), sources()).map);
  };
  const double expected = radius({});
  EXPECT_NEAR(radius({"subsystems.controller.source=diagram:controller.toml"}), expected, 1e-9);
  EXPECT_LT(expected, 0.98);
  EXPECT_GT(radius({"subsystems.controller.parameters.kp=120"}), 1.0);
}

/// Over one period of the controller: 2 cos of the turn times the modulus, and its square, of each mode.
std::vector<std::array<double, 2>> sums_and_products(const std::vector<stability::Mode>& modes,
                                                     double period) {
  std::vector<std::array<double, 2>> all;
  for (const auto& mode : modes) {
    const double modulus = std::exp(mode.rate * period);
    all.push_back({modulus * std::cos(2.0 * std::numbers::pi * mode.frequency * period), modulus});
  }
  std::ranges::sort(all);
  return all;
}

std::vector<std::array<double, 2>> sums_and_products(const MatrixXd& map) {
  std::vector<std::array<double, 2>> all;
  const Eigen::VectorXcd values = map.eigenvalues();
  for (const auto value : values)
    if (value.imag() >= 0.0 && std::abs(value) > 1e-4) all.push_back({value.real(), std::abs(value)});
  std::ranges::sort(all);
  return all;
}

/// A side that is exact for held forces leaves nothing to a scheme: its modes are the true ones, whose eigenvalues are those
/// of matrix exponentials from instant to instant.
TEST(StabilityOfSamples, ModesAreThoseOfTheMatrixExponentials) {
  std::mt19937_64 random(13);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const double parts[] = {1.0, 0.5, 0.2, 2.0 / 3.0};
  for (int k = 0; k < 40; ++k) {
    const double period = between(0.1, 1.0);
    const Gains gains{between(0.0, 8.0),
                      between(0.0, 2.0),
                      between(0.1, 2.0),
                      period,
                      k % 3 == 0 ? 0.0 : between(0.0, 2.5) * period,
                      k % 2 == 0 ? 0.0 : between(0.0, k % 4 == 1 ? 1.0 : 2.7) * period};
    const Scratch folder;
    const auto one =
        scene_of(folder, {parts[k % 4] * period}, 0.0, k % 5 == 0 ? "parallel" : "slowest-first", 5.0);
    const auto found = stability::stability(one, with_controller(gains));
    ASSERT_EQ(found.unknown, "") << k;
    for (const auto& mode : found.modes) {
      EXPECT_GT(mode.likeness, 0.999) << k;
      EXPECT_NEAR(mode.growth, std::exp(mode.rate * found.step.period), 1e-7) << k;
      EXPECT_NEAR(mode.scheme_frequency, mode.frequency, 1e-7 / period) << k;
    }
    if (gains.latency > period) continue;  // more outputs wait than the map of matrix exponentials has
    const auto here = sums_and_products(found.modes, period), expected = sums_and_products(exact_map(gains));
    ASSERT_EQ(here.size(), expected.size()) << k;
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(here[i][j], expected[i][j], 1e-7) << k;
  }
}

/// Slow against what the controller does the mode is that of the oscillator with the controller's gains in it.
TEST(StabilityOfSamples, AFastControllerIsASpringAndADamper) {
  const Scratch folder;
  const auto one = scene_of(folder, {0.01}, 0.0, "slowest-first", 5.0);
  const auto found = stability::stability(one, with_controller({3.0, 0.6, 0.0, 0.001, 0.0, 0.0}));
  ASSERT_EQ(found.unknown, "");
  const auto& mode = found.modes.front();
  EXPECT_NEAR(mode.frequency, std::sqrt(4.0 - 0.16) / (2.0 * std::numbers::pi), 1e-3);
  EXPECT_NEAR(mode.damping, 0.2, 1e-3);
  EXPECT_EQ(found.mostly(mode), "side1.x, side1.v");
}

/// A weight that comes once is sampled in 1 s. It reads nobody, and takes no part in the super-step.
TEST(StabilityOfSamples, WhatReadsNobodyMovesNothing) {
  const auto modes = [](const char* file, double period) {
    const auto found = stability::stability(scene(file, {}), sources());
    EXPECT_EQ(found.unknown, "");
    EXPECT_NEAR(found.step.period, period, 1e-12);
    return found.modes;
  };
  const auto with = modes("drive/drive_mechanism.toml", 2.5e-3),
             without = modes("drive/drive_libraries.toml", 2.5e-3);
  ASSERT_EQ(with.size(), without.size()) << "the mechanism has an angle more, at rest";
  for (std::size_t k = 0; k < without.size(); ++k) EXPECT_NEAR(with[k].growth, without[k].growth, 1e-6);
}

/// What grows slowly beside a short super-step is not at rest.
TEST(StabilityOfSamples, AnUnstableLoopIsToldAtAnyStep) {
  for (const double period : {0.2, 0.002, 2e-4}) {
    const Scratch folder;
    const auto one = scene_of(folder, {period}, 0.0, "slowest-first", 5.0);
    const Gains gains{-2.0, 0.0, 0.0, period, 0.0, 0.0};
    const auto found = stability::stability(one, with_controller(gains));
    EXPECT_NEAR(found.rate, std::log(exact_radius(gains)) / period, 1e-6) << period;
    EXPECT_GT(found.rate, 0.8);
    EXPECT_NEAR(std::log(found.radius), found.rate * found.step.period, 1e-7) << period;
  }
}

TEST(StabilityOfSamples, WhatStandsForASampledOneIsTold) {
  const Scratch folder;
  const auto one = scene_of(folder, {0.1}, 0.0, "slowest-first", 5.0);
  const auto found = stability::stability(one, with_controller({1.0, 0.1, 0.2, 0.3, 0.0, 0.0}));
  ASSERT_EQ(found.step.identified.size(), 1U);
  EXPECT_EQ(found.step.identified[0].name, "control");
  EXPECT_TRUE(found.step.identified[0].sampled);
  EXPECT_EQ(found.step.identified[0].order, 1);
  EXPECT_EQ(found.step.steps, (std::vector<std::int64_t>{3, 1}));
  const auto gains = Gains{2.0, 0.0, 0.0, 0.3, 0.0, 0.0};
  EXPECT_GT(stability::stability(one, with_controller(gains)).rate, 0.0) << "the sampled loop grows";
  const auto largest = stability::largest_step(one, with_controller(gains));
  EXPECT_GT(largest.factor, 1.0) << "but the scheme lets it grow no faster than it does";
  EXPECT_EQ(largest.smallest, 1.0);
  EXPECT_EQ(largest.whose, "side1") << "not that of the controller, which is longer";
  EXPECT_NEAR(largest.step, 0.1, 1e-12);
}

}  // namespace
}  // namespace tandem::stability_of_samples_tests
