// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The integrators of second-order problems on oscillators of which all is known.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "memory_of.hpp"
#include "refusal.hpp"
#include "tandem/mbs/integrators/frequency.hpp"
#include "tandem/mbs/integrators/newmark.hpp"
#include "tandem/mbs/integrators/runge_kutta.hpp"

namespace tandem::mbs {
namespace {

/// y'' = -omega^2 y - 2 damping omega y' + push, omega by component.
class Oscillators final : public SecondOrder {
 public:
  explicit Oscillators(Eigen::VectorXd omega, double damping = 0.0)
      : omega_(std::move(omega)), damping_(damping) {}
  int size() const override { return static_cast<int>(omega_.size()); }
  void accelerations(double, const double* y, const double* v, double* a) override {
    for (int i = 0; i < size(); ++i)
      a[i] = -omega_[i] * omega_[i] * y[i] - 2.0 * damping_ * omega_[i] * v[i] + push;
    ++evaluations;
  }
  double push = 0.0;
  int evaluations = 0;

 private:
  Eigen::VectorXd omega_;
  double damping_;
};

Motion run(Integrator& method, SecondOrder& problem, Motion m, double h, int steps) {
  problem.accelerations(m.time, m.y.data(), m.v.data(), m.a.data());
  method.start(problem, m);
  const double first = m.time;
  for (int k = 1; k <= steps; ++k) method.step(problem, m, h, first + k * h);
  return m;
}

Motion resting(double y) {
  return {0.0, Eigen::VectorXd::Constant(1, y), Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1)};
}

/// Error of y and y' of a damped oscillator at t = 2, from y = 1, y' = 0.
double error(Integrator& method, int steps) {
  constexpr double omega = 3.0, damping = 0.1, end = 2.0;
  Oscillators problem(Eigen::VectorXd::Constant(1, omega), damping);
  const Motion m = run(method, problem, resting(1.0), end / steps, steps);
  const double d = damping * omega, w = omega * std::sqrt(1.0 - damping * damping), f = std::exp(-d * end),
               y = f * (std::cos(w * end) + d / w * std::sin(w * end)),
               v = -f * (w + d * d / w) * std::sin(w * end);
  return std::hypot(m.y[0] - y, m.v[0] - v);
}

TEST(Integrators, HaveTheirOrders) {
  RungeKutta rk2(midpoint_rule()), rk4(classical_runge_kutta()), rk8(dormand_prince8());
  NewmarkFamily newmark(NewmarkSettings{.tolerance = 1e-13}),
      alpha(GeneralizedAlphaSettings{.spectral_radius = 0.5, .tolerance = 1e-13});
  const auto order = [](Integrator& m, int steps = 200) {
    return std::log2(error(m, steps) / error(m, 2 * steps));
  };
  EXPECT_NEAR(order(rk2), 2.0, 0.2);
  EXPECT_NEAR(order(rk4), 4.0, 0.2);
  EXPECT_NEAR(order(rk8, 10), 8.0, 0.4);
  EXPECT_NEAR(order(newmark), 2.0, 0.2);
  EXPECT_NEAR(order(alpha), 2.0, 0.2);
}

/// The evaluation at a step's end is the first stage of the next step.
TEST(RungeKutta, TakesAsManyEvaluationsAsItHasStages) {
  for (const auto& [table, stages] : {std::pair{classical_runge_kutta(), 4}, {dormand_prince8(), 12}}) {
    Oscillators problem(Eigen::VectorXd::Ones(1));
    RungeKutta method(table);
    run(method, problem, resting(1.0), 0.1, 10);
    EXPECT_EQ(problem.evaluations, 10 * stages + 1);
  }
}

/// A stage stands at its time: sum a_ij = c_i.
TEST(RungeKutta, HasTablesWhoseStagesStandAtTheirTimes) {
  for (const RungeKuttaTable& t : {midpoint_rule(), classical_runge_kutta(), dormand_prince8()})
    for (std::size_t i = 0; i < t.c.size(); ++i) {
      EXPECT_EQ(t.a[i].size(), i);
      EXPECT_NEAR(std::accumulate(t.a[i].begin(), t.a[i].end(), 0.0), t.c[i], 1e-14) << i;
    }
}

/// Radians by which y'' = -y is behind after 16.25 periods: from rest y_k = cos(phi k) with
/// cos phi = 1 - x/(2 (1 + beta x)), x = h^2, so phi = h [1 - (beta - 1/12) h^2/2 + O(h^4)].
double phase_error(double beta, int steps) {
  Oscillators problem(Eigen::VectorXd::Ones(1));
  NewmarkFamily newmark(NewmarkSettings{.beta = beta, .tolerance = 1e-13});
  return std::asin(run(newmark, problem, resting(1.0), 32.5 * std::numbers::pi / steps, steps).y[0]);
}

TEST(Newmark, HasAPeriodErrorOfOrderFourWithBetaOneTwelfthAndOfOrderTwoElse) {
  const auto order = [](double beta) { return std::log2(phase_error(beta, 500) / phase_error(beta, 1000)); };
  EXPECT_NEAR(order(1.0 / 12.0), 4.0, 0.2);
  EXPECT_NEAR(order(1.0 / 6.0), 2.0, 0.2);
  EXPECT_NEAR(order(1.0 / 4.0), 2.0, 0.2);
}

/// omega h = 1/sqrt(1/4 - beta): sqrt(6) with beta = 1/12. The frequency is told to 1e-6 by differences.
TEST(Newmark, RefusesStepsBeyondItsStabilityLimit) {
  Eigen::VectorXd omega(3);
  omega << 1.0, 40.0, 100.0;
  Oscillators problem(omega);
  Motion m{0.0, Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)};
  EXPECT_NEAR(highest_frequency(problem, m), 100.0, 1e-3);
  NewmarkFamily newmark(NewmarkSettings{.beta = 1.0 / 12.0}), trapezoidal(NewmarkSettings{});
  newmark.start(problem, m);
  newmark.step(problem, m, 0.0244, 0.0244);
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"beta = 0.08333", "omega h = 2.449", "100 rad/s", "2.46"},
                            [&] { newmark.step(problem, m, 0.0246, 0.049); }));
  trapezoidal.start(problem, m);
  trapezoidal.step(problem, m, 0.0199, 0.049);  // the iteration's own limit is omega h = 2
}

/// A spring that is four times as stiff from 1 s on.
class StiffeningSpring final : public SecondOrder {
 public:
  int size() const override { return 1; }
  void accelerations(double t, const double* y, const double*, double* a) override {
    a[0] = (t < 1.0 ? -1e4 : -4e4) * y[0];
  }
};

/// omega h = 1.6 at first, 3.2 then: beyond the limit of 2.449 before the iteration's own, 3.46.
TEST(Newmark, SeesWithinFiftyStepsThatItsLimitIsPassed) {
  StiffeningSpring problem;
  Motion m{0.0, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1)};
  NewmarkFamily newmark(NewmarkSettings{.beta = 1.0 / 12.0}), restored(NewmarkSettings{.beta = 1.0 / 12.0});
  newmark.start(problem, m);
  int k = 1;
  for (; k <= 90; ++k) newmark.step(problem, m, 0.016, k * 0.016);
  restored.start(problem, m);
  restored.recall(test::memory_of(newmark));
  const auto more = [&](NewmarkFamily& method) {
    Motion last = m;
    for (; k <= 101; ++k) method.step(problem, last, 0.016, k * 0.016);
  };
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"t = 1.6 s", "200 rad/s", "3.2"}, [&] { more(newmark); }));
  k = 91;
  EXPECT_TRUE(test::refuses(ErrorCode::numerical, {"t = 1.6 s", "200 rad/s"}, [&] { more(restored); }));
}

/// Just below the limit the motion stays as it began, just above it grows: the limit is where it says. The
/// method's recurrence is y+ - (2 - x/(1 + beta x)) y + y- = 0.
TEST(Newmark, IsStableUpToTheLimit) {
  for (const double beta : {1.0 / 12.0, 1.0 / 6.0, 0.2})
    for (const double factor : {0.99, 1.01}) {
      const double wh = factor * newmark_limit(beta), x = wh * wh, trace = 2.0 - x / (1.0 + beta * x);
      EXPECT_EQ(std::abs(trace) <= 2.0, factor < 1.0) << beta;
    }
  EXPECT_EQ(newmark_limit(0.25), HUGE_VAL);
}

TEST(Newmark, SaysWhenItsIterationDoesNotConverge) {
  Oscillators problem(Eigen::VectorXd::Ones(1));
  NewmarkFamily newmark(NewmarkSettings{});
  EXPECT_TRUE(test::refuses(ErrorCode::numerical,
                            {"no convergence at t = 2.1 s in 30 iterations", "no shorter"},
                            [&] { run(newmark, problem, resting(1.0), 2.1, 1); }));
}

/// A step of y'' = -x y, h = 1, as J. Chung and G. Hulbert write it: the force at the mean position.
void literal_step(double rho, double x, double& y, double& v, double& a) {
  const double am = (2.0 * rho - 1.0) / (rho + 1.0), af = rho / (rho + 1.0), gamma = 0.5 - am + af,
               beta = std::pow(1.0 - am + af, 2) / 4.0, known = y + v + (0.5 - beta) * a,
               next = -(am * a + x * ((1.0 - af) * known + af * y)) / (1.0 - am + x * (1.0 - af) * beta);
  y = known + beta * next;
  v += (1.0 - gamma) * a + gamma * next;
  a = next;
}

/// The code iterates on accelerations to 1e-13 of the rates.
TEST(GeneralizedAlpha, TakesTheStepsOfTheLiterature) {
  for (const double rho : {0.0, 0.5, 0.8, 1.0}) {
    Oscillators problem(Eigen::VectorXd::Ones(1));
    NewmarkFamily alpha(
        GeneralizedAlphaSettings{.spectral_radius = rho, .tolerance = 1e-13, .most_iterations = 300});
    const Motion m = run(alpha, problem, resting(1.0), 0.9, 10);
    double y = 1.0, v = 0.0, a = -0.81;  // in units of h
    for (int k = 0; k < 10; ++k) literal_step(rho, 0.81, y, v, a);
    EXPECT_NEAR(m.y[0], y, 1e-11) << rho;
    EXPECT_NEAR(0.9 * m.v[0], v, 1e-11) << rho;
  }
}

/// Of infinite frequencies a step leaves the spectral radius; it is a double root, so after 400 steps there
/// is up to some 400^2 times more: 400^(2/400) = 1.03.
TEST(GeneralizedAlpha, LeavesItsSpectralRadiusOfTheHighestFrequencies) {
  for (const double rho : {0.5, 0.8}) {
    double y = 1.0, v = 0.3, a = 0.2;
    for (int k = 0; k < 400; ++k) literal_step(rho, 1e12, y, v, a);
    EXPECT_NEAR(std::pow(std::abs(v) + std::abs(a), 1.0 / 400.0) / rho, 1.0, 0.05);
  }
}

/// A force that jumps between steps: the method's own accelerations keep their lag behind it, so that order 2
/// stays though the force is refreshed at each step. y'' = -y + t with t held at the middle of each step.
TEST(GeneralizedAlpha, KeepsItsOrderWithAForceThatIsRefreshed) {
  const auto error_with = [](int steps) {
    Oscillators problem(Eigen::VectorXd::Ones(1));
    NewmarkFamily alpha(GeneralizedAlphaSettings{.spectral_radius = 0.5, .tolerance = 1e-13});
    Motion m = resting(0.0);
    const double h = 2.0 / steps;
    alpha.start(problem, m);
    for (int k = 1; k <= steps; ++k) {
      problem.push = (k - 0.5) * h;
      problem.accelerations(m.time, m.y.data(), m.v.data(), m.a.data());
      alpha.step(problem, m, h, k * h);
    }
    return std::abs(m.y[0] - (2.0 - std::sin(2.0)));
  };
  EXPECT_NEAR(std::log2(error_with(100) / error_with(200)), 2.0, 0.2);
}

/// x' = -x.
class Decay final : public FirstOrder {
 public:
  int size() const override { return 1; }
  void rates(double, const double* x, double* rate) override { rate[0] = -x[0]; }
};

TEST(AsSecondOrder, MakesNewmarksMethodTheTrapezoidalRuleWhateverItsBeta) {
  for (const double beta : {1.0 / 12.0, 0.25}) {
    Decay decay;
    AsSecondOrder problem(decay);
    Motion m = resting(0.0);
    m.v[0] = 1.0;
    NewmarkFamily newmark(NewmarkSettings{.beta = beta, .tolerance = 1e-14});
    const double h = 0.1, factor = (1.0 - h / 2.0) / (1.0 + h / 2.0);
    EXPECT_NEAR(run(newmark, problem, m, h, 10).v[0], std::pow(factor, 10), 1e-13);
  }
}

TEST(AsFirstOrder, HasTheRatesOfPositionsAndVelocities) {
  Oscillators problem(Eigen::VectorXd::Constant(1, 2.0));
  AsFirstOrder first(problem);
  const double x[] = {3.0, 5.0};
  double rate[2];
  first.rates(0.0, x, rate);
  EXPECT_EQ(first.size(), 2);
  EXPECT_EQ(rate[0], 5.0);
  EXPECT_EQ(rate[1], -12.0);
}

}  // namespace
}  // namespace tandem::mbs
