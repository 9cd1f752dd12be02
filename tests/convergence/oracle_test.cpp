// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The real coordinator and sides against the independent program tests/oracle/two_mass_oracle, in states and
// figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "two_mass/experiment.hpp"
#include "two_mass_oracle.hpp"
#include "two_mass_run.hpp"

namespace tandem::test {
namespace {

using two_mass::Case;
using two_mass::Scheme;

constexpr double cycles = 12.0;  // ten are needed to fit the fast mode

/// How much a reader that is a whole slow step ahead magnifies rounding of the fast side's samples, r to a
/// step: the sum of |weights| of an extrapolation over r samples is about (2r)^d / d! for degree d, and 6 r^3
/// for Hermite's cubic.
double magnification(const std::string& scheme, double r) {
  const Reconstruction how = Reconstruction::parse(scheme);
  if (how.kind == Reconstruction::Kind::hermite) return 6.0 * r * r * r;
  return std::max(1.0, std::pow(2.0 * r, how.degree) / std::tgamma(how.degree + 1.0));
}

/// Relative to the largest displacement: rounding of about 10 eps a fast step (some 1000 in all) and, a few
/// times over, what extrapolation makes of it. Where a run is unstable both grow alike.
double tolerance_of(const Case& c) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  return 20.0 * eps * (600.0 + magnification(c.scheme.to_slow, c.frequency_ratio));
}

std::string arguments(const Case& c, const std::string& start) {
  std::ostringstream text;
  text.precision(17);
  text << c.scheme.schedule << ' ' << c.scheme.to_fast << ' ' << c.scheme.to_slow << ' ' << c.frequency_ratio
       << " --cycles " << c.cycles << (start.empty() ? "" : " --start ") << start
       << (c.reuse_acceleration ? " --reuse-acceleration" : "");
  return text.str();
}

void compare_states(const OracleRow& oracle, const TwoMassResult& real, double tolerance) {
  double largest = 0.0;
  for (const Node& n : real.fast) largest = std::max(largest, std::abs(n.x));
  const double limit = tolerance * largest;
  const two_mass::Model& m = real.model;
  EXPECT_NEAR(oracle.x1, real.fast.back().x, limit);
  EXPECT_NEAR(oracle.v1, real.fast.back().v, limit * m.omega1);
  EXPECT_NEAR(oracle.x2, real.slow.back().x, limit);
  EXPECT_NEAR(oracle.v2, real.slow.back().v, limit * m.omega1);
  EXPECT_EQ(oracle.fast_steps, static_cast<long>(real.fast.size()) - 1);
  EXPECT_EQ(oracle.slow_steps, static_cast<long>(real.slow.size()) - 1);
}

/// Figures are made of differences that may be smaller than what they are taken of, so to a part of their
/// scale.
void compare_figure(const char* name, double oracle, const std::optional<double>& real, double limit) {
  if (!real) return;  // without meaning in this run, which its note says
  EXPECT_NEAR(oracle, *real, limit * std::max(1.0, std::abs(oracle))) << name;
}

void compare_figures(const OracleRow& oracle, const two_mass::Figures& real, double tolerance) {
  ASSERT_FALSE(real.failed) << real.note;
  ASSERT_TRUE(real.position_error && real.energy_error && real.exchange_energy_error);
  ASSERT_TRUE((real.amplitude_error && real.phase_error) || !real.note.empty());
  const double limit = 10.0 * tolerance;  // energies are squares; velocities from cubics have a factor of 3
  compare_figure("position error", oracle.position_error, real.position_error, limit);
  compare_figure("energy error", oracle.energy_error, real.energy_error, limit);
  compare_figure("exchange energy error", oracle.exchange_energy_error, real.exchange_energy_error, limit);
  compare_figure("amplitude error", oracle.amplitude_error, real.amplitude_error,
                 10.0 * limit);  // a fit of both modes
  compare_figure("phase error", oracle.phase_error, real.phase_error, 10.0 * limit);
}

TwoMassRun real_run(const Case& c) {
  TwoMassRun what;
  what.settings.frequency_ratio = c.frequency_ratio;
  what.schedule = Schedule::parse(c.scheme.schedule);
  what.to_fast = c.scheme.to_fast;
  what.to_slow = c.scheme.to_slow;
  what.t_stop = c.cycles;
  what.fast = real_fast();
  what.slow = c.reuse_acceleration ? reusing_slow() : real_slow();
  return what;
}

/// Cold where the passes of a repeated start did not settle.
std::string start_of(const TwoMassResult& real) {
  return real.start_passes == 0 ? "" : std::string(name(real.start));
}

void compare(const Case& c) {
  SCOPED_TRACE(arguments(c, ""));
  const TwoMassResult real = run(real_run(c));
  const OracleRow oracle = ask_oracle(arguments(c, start_of(real)));
  compare_states(oracle, real, tolerance_of(c));
  const auto of_degree_four = [](const std::string& how) {
    return how == "lagrange4" || how.starts_with("least_squares4");
  };
  const bool repeats = of_degree_four(c.scheme.to_fast) || of_degree_four(c.scheme.to_slow);
  EXPECT_TRUE(repeats || oracle.calls == real.exchanges) << oracle.calls << " calls, not " << real.exchanges;
  compare_figures(oracle, two_mass::run_case(c).figures, tolerance_of(c));
}

class Oracle : public testing::TestWithParam<double> {
 protected:
  Case at(const std::string& schedule, const std::string& to_fast, const std::string& to_slow) const {
    return {.scheme = {schedule, to_fast, to_slow}, .frequency_ratio = GetParam(), .cycles = cycles};
  }
};

TEST_P(Oracle, AgreesOnLagrange) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* scheme : {"lagrange0", "lagrange1", "lagrange2", "lagrange3", "lagrange4"})
      compare(at(schedule, scheme, scheme));
}

TEST_P(Oracle, AgreesOnTwoDegrees) {
  for (const char* schedule : {"slowest-first", "fastest-first"}) {
    compare(at(schedule, "lagrange3", "lagrange0"));
    compare(at(schedule, "lagrange1", "lagrange4"));
  }
}

TEST_P(Oracle, AgreesOnHermiteAndLeastSquares) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* scheme : {"hermite", "least_squares0_3", "least_squares1_4", "least_squares2_2",
                               "least_squares3_4", "least_squares4_2"})
      compare(at(schedule, scheme, scheme));
}

TEST_P(Oracle, AgreesOnTheMean) {
  for (const char* to_fast : {"lagrange0", "lagrange3", "least_squares2_4"})
    compare(at("fastest-first", to_fast, "mean"));
}

TEST_P(Oracle, AgreesOnMatchedHold) {
  for (const char* schedule : {"slowest-first", "fastest-first", "staggered"})
    compare(at(schedule, "matched_hold", "matched_hold"));
}

TEST_P(Oracle, AgreesOnAStoredAcceleration) {
  Case c = at("slowest-first", "lagrange0", "lagrange0");
  c.reuse_acceleration = true;
  compare(c);
}

TEST_P(Oracle, AgreesOnEachStart) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* scheme : {"lagrange2", "lagrange3", "hermite", "least_squares3_2"}) {
      const Case c = at(schedule, scheme, scheme);
      TwoMassRun what = real_run(c);
      SCOPED_TRACE(arguments(c, ""));
      what.start = StartKind::cold;
      compare_states(ask_oracle(arguments(c, "cold")), run(what), tolerance_of(c));
      what.start = StartKind::repeat;
      const TwoMassResult repeated = run(what);
      compare_states(ask_oracle(arguments(c, start_of(repeated))), repeated, tolerance_of(c));
    }
}

INSTANTIATE_TEST_SUITE_P(FrequencyRatio, Oracle, testing::Values(1.7721, 3.0, 25.0, 30.7, 90.0),
                         [](const auto& ratio) {
                           std::string name = std::to_string(ratio.param);
                           name.replace(name.find('.'), 1, "_");
                           return name.substr(0, name.find_last_not_of("0_") + 1);
                         });

}  // namespace
}  // namespace tandem::test
