// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A repeated start where it gains least from a pass: first-order subsystems that feed each other, without and
// with feedthrough (exact_relaxation.hpp).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "exact_relaxation.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "two_mass_run.hpp"

namespace tandem::test {
namespace {

/// Sums the squares of the distance to the exact motion: A is subsystem 0.
class Distance final : public Observer {
 public:
  explicit Distance(const Relaxation& system) : system_(system) {}
  bool samples(int who, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t row = first; row <= last; ++row) {
      const auto [a, b] = system_.exact(history.time(row));
      const double d = history.values(row)[0] - (who == 0 ? a : b + system_.k * a);
      sum_ += d * d;
      ++count_;
    }
    return true;
  }
  double root_mean_square() const { return std::sqrt(sum_ / static_cast<double>(count_)); }

 private:
  Relaxation system_;
  double sum_ = 0.0;
  std::int64_t count_ = 0;
};

/// Error over 4 s with own steps h/2.5 (A) and h (B), from a repeated start.
double error_at(double h, const Relaxation& system, Schedule::Kind schedule, int degree) {
  FixedStep<ExactRelaxation> a(ExactRelaxation(system, {.first = true, .h = h / 2.5}));
  FixedStep<ExactRelaxation> b(ExactRelaxation(system, {.first = false, .h = h}));
  Topology topology;
  topology.add("A", a.info());
  topology.add("B", b.info());
  const auto how = Reconstruction::parse("lagrange" + std::to_string(degree));
  topology.connect({"A.y", "B.u", how});
  topology.connect({"B.y", "A.u", how});
  topology.check();
  Coordination coordination;
  coordination.schedule = schedule;
  coordination.start = StartKind::repeat;
  Coordinator coordinator(topology, {&a, &b}, coordination, {0.0, 4.0});
  Distance distance(system);
  coordinator.observe(&distance);
  coordinator.run();
  return distance.root_mean_square();
}

/// Settled at H = 1/320 s, where the start's own error, of order 2d, has sunk below the run's.
void expect_full_order(const Relaxation& system) {
  using enum Schedule::Kind;
  for (const auto schedule : {slowest_first, fastest_first, parallel})
    for (int degree = 2; degree <= 3; ++degree) {
      const double coarse = error_at(1.0 / 320, system, schedule, degree);
      const double fine = error_at(1.0 / 640, system, schedule, degree);
      EXPECT_NEAR(order(coarse, fine), degree + 1, 0.2) << Schedule::name(schedule) << " degree " << degree;
    }
}

TEST(RepeatedStart, ReachesTheFullOrderOfAFirstOrderCoupling) { expect_full_order({.k = 0.0}); }

// A feedthrough delays what a pass gains by one pass: degree + 1 passes in all would leave order 3 at
// degree 3.
TEST(RepeatedStart, ReachesTheFullOrderOfAFirstOrderCouplingWithFeedthrough) {
  expect_full_order({.k = 1.0});
}

}  // namespace
}  // namespace tandem::test
