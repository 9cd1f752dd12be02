// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What runs inside an FMU of Model Exchange, call by call.
#include "tandem/exported/exchanged_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exports.hpp"
#include "random_diagram.hpp"
#include "refusal.hpp"

namespace tandem::test {
namespace {

using exported::Interface;
using fmi::Version;

TEST(ExchangedUnit, DoesWhatIsDueWhereItIsTold) {
  const Exports exports;
  exported::ExchangedUnit unit(
      exports.unpacked(exports.fmu("ball", ball, Version::two, Interface::model_exchange)));
  EXPECT_TRUE(refuses(ErrorCode::wrong_state, {"start"}, [&] { unit.set_time(0.1); }));
  unit.begin();
  EXPECT_EQ(unit.event(), std::numeric_limits<double>::infinity());
  const double falling[] = {-3.0, -1e-12}, rising[] = {2.0, 1.0};
  unit.set_time(0.4), unit.set_states(falling);
  const double next = unit.event();
  EXPECT_NEAR(next, 0.4 + 1e-8, 1e-12);
  double x[2];
  unit.get_states(x);
  EXPECT_EQ(x[0], 0.7 * 3.0);
  unit.set_time(next), unit.set_states(rising);
  EXPECT_EQ(unit.event(), std::numeric_limits<double>::infinity());
  unit.get_states(x);
  EXPECT_EQ(x[0], 2.0);
}

/// y = x - y^2 has two solutions; the one near that of the last step counts, whatever was tried since.
TEST(ExchangedUnit, WhatATryGivesDependsOnNoTryBefore) {
  const Exports exports;
  exported::ExchangedUnit unit(exports.unpacked(
      exports.fmu("loop",
                  "[blocks]\ny2 = { kind = 'function', function = 'square', input = 'y' }\n"
                  "y = { kind = 'sum', inputs = ['x', 'y2'], gains = [1, -1] }\n"
                  "dx = { kind = 'sum', inputs = ['x', 'y'], gains = [-50, -0.1] }\n"
                  "x = { kind = 'integrator', input = 'dx', initial = 5 }\n[loops]\nsolve = true\n[outputs]\n"
                  "x = { unit = '1' }\ny = { unit = '1' }\n[run]\nstep = 0.1\n",
                  Version::two, Interface::model_exchange)));
  unit.begin(), unit.event();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(-0.24, 20.0);
  double rate = 0.0;
  const auto rate_at = [&](double x) {
    unit.set_states({&x, 1});
    unit.get_rates({&rate, 1});
    return rate;
  };
  for (double x = 5.0; x > -0.2; x -= 0.05) rate_at(x), unit.step_done();
  const double right = rate_at(-0.2);
  EXPECT_NEAR(right, 10.0 - 0.1 * (std::sqrt(0.2) - 1.0) / 2.0, 1e-6);
  const auto state = unit.state();
  for (int k = 0; k < 50; ++k) {
    try {
      rate_at(any(random));
    } catch (const Error& error) {  // no solution from there
      EXPECT_EQ(error.code(), ErrorCode::numerical);
    }
    EXPECT_EQ(rate_at(-0.2), right);
  }
  unit.restore(state);
  EXPECT_EQ(rate_at(-0.2), right);
  rate_at(1.317);
  const double x = -0.2;
  unit.set_states({&x, 1});
  unit.event();
  unit.get_rates({&rate, 1});
  EXPECT_NEAR(rate, right, 1e-6);
}

/// The states after a reset are those of another start.
TEST(ExchangedUnit, BeginsAnewAfterAReset) {
  const Exports exports;
  exported::ExchangedUnit unit(
      exports.unpacked(exports.fmu("ball", ball, Version::two, Interface::model_exchange)));
  double before[2], after[2], z[1];
  unit.get_states(before);  // as in initialization
  unit.begin();
  const double other[] = {5.0, 7.0};
  unit.set_time(1.0), unit.set_states(other);
  unit.reset();
  unit.get_states(after), unit.get_indicators(z);
  EXPECT_TRUE(std::equal(before, before + 2, after));
  EXPECT_EQ(z[0], -1.0);
}

/// An importer of its own: Euler's method with events, by chance.
class Importer {
 public:
  explicit Importer(exported::ExchangedUnit& unit) : unit_(unit), x_(unit.states_size()), dx_(x_) {}

  void begin() {
    unit_.begin();
    next_ = unit_.event();
  }
  void step(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1.0, 1.0), length(0.001, 0.03);
    const double begin = unit_.time(), end = std::min(begin + length(random), next_);
    unit_.set(1, any(random)), unit_.set(2, any(random));
    unit_.get_states(x_), unit_.get_rates(dx_);
    std::vector<double> z(unit_.indicators_size()), now(z);
    unit_.get_indicators(z);
    for (std::size_t k = 0; k < x_.size(); ++k) x_[k] += (end - begin) * dx_[k];
    unit_.set_time(end), unit_.set_states(x_);
    unit_.step_done();
    unit_.get_indicators(now);
    const bool crossed =
        !std::equal(z.begin(), z.end(), now.begin(), [](double a, double b) { return a * b > 0.0; });
    if (crossed || end >= next_) next_ = unit_.event();
  }
  std::vector<double> numbers() {
    std::vector<double> all;
    for (std::size_t k = 0; k < unit_.variables().size(); ++k)
      if (unit_.variable(k).kind < exported::Variable::Kind::word) all.push_back(unit_.number(k));
    return all;
  }
  double next() const { return next_; }
  void go_on(double next) { next_ = next; }

 private:
  exported::ExchangedUnit& unit_;
  std::vector<double> x_, dx_;
  double next_ = 0.0;
};

TEST(ExchangedUnit, GoesOnFromItsStateWithTheSameBitsHereAndInAnotherInstance) {
  std::mt19937 random(29);
  const Exports exports;
  int made = 0;
  for (int k = 0; k < 25; ++k) {
    const std::string name = "s" + std::to_string(k), text = RandomDiagram(random).text();
    SCOPED_TRACE(text);
    if (text.find("'delay'") != std::string::npos) continue;
    const auto file = exports.folder.write(name + ".toml", text);
    const auto resources = exports.unpacked(
        exports.of("diagram:" + file.string() + "?step=0.03", name, Version::two, Interface::model_exchange));
    exported::ExchangedUnit one(resources), other(resources);
    one.set_span(k - 5.0);
    one.set(one.variables().size() - 2, 0.7);  // the parameter k
    Importer of_one(one), of_other(other);
    of_one.begin();
    for (int steps = 0; steps < 3 * k; ++steps) of_one.step(random);
    const auto state = one.state();
    other.restore(state);
    EXPECT_EQ(other.state(), state);
    of_other.go_on(of_one.next());
    std::mt19937 same = random;
    for (int steps = 0; steps < 50; ++steps) of_one.step(random), of_other.step(same);
    EXPECT_EQ(of_one.numbers(), of_other.numbers());
    one.reset();
    exported::ExchangedUnit fresh(resources);
    EXPECT_EQ(of_one.numbers(), Importer(fresh).numbers());
    ++made;
  }
  EXPECT_GT(made, 8);
}

}  // namespace
}  // namespace tandem::test
