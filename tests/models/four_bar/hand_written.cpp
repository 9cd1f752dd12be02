// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/hand_written.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tandem::four_bar {
namespace {

constexpr double gravity = 9.81;  // [m/s^2]

/// A rod of 1 kg: a third of its mass at each end, a sixth between them.
mbs::Matrix mass(int loops) {
  const int points = loops + 1;
  std::vector<std::pair<int, int>> entries;
  for (int i = 0; i < 2 * points; ++i) entries.emplace_back(i, i);
  for (int i = 0; i < 2 * loops; ++i) entries.insert(entries.end(), {{i, i + 2}, {i + 2, i}});
  mbs::Matrix m{mbs::Pattern(2 * points, 2 * points, std::move(entries)), {}};
  for (const auto& [row, column] : m.pattern.entries()) {
    const bool at_an_end = row / 2 == 0 || row / 2 == loops;
    m.values.push_back(row != column ? 1.0 / 6.0 : at_an_end ? 2.0 / 3.0 : 1.0);
  }
  return m;
}

mbs::Pattern jacobian(int loops) {
  const int points = loops + 1;
  std::vector<std::pair<int, int>> entries;
  for (int i = 0; i < points; ++i)
    for (int k = 0; k < 2; ++k) entries.emplace_back(2 * i + k, i);
  for (int i = 0; i < loops; ++i)
    for (int k = 0; k < 4; ++k) entries.emplace_back(2 * i + k, points + i);
  return {2 * points, points + loops, std::move(entries)};
}

}  // namespace

HandWritten::HandWritten(int loops) : loops_(loops) {
  const int points = loops + 1, n = 2 * points;
  structure_.coordinates = structure_.variables = n;
  structure_.constraints = points + loops;
  structure_.mass = mass(loops);
  structure_.jacobian = jacobian(loops);
  structure_.stiffness = mbs::Pattern(n, n, {});
  for (int i = 0; i < points; ++i) {
    const std::string number = std::to_string(i);
    structure_.variable_names.insert(structure_.variable_names.end(),
                                     {"B" + number + ".x", "B" + number + ".y"});
    structure_.constraint_names.push_back("crank" + number);
    const bool at_an_end = i == 0 || i == loops;
    weight_.insert(weight_.end(), {0.0, -gravity * (at_an_end ? 1.0 : 1.5)});
  }
  for (int i = 0; i < loops; ++i) structure_.constraint_names.push_back("coupler" + std::to_string(i));
}

void HandWritten::constraints(const double* q, double* phi, double* jacobian) const {
  const double* const end = q + 2 * loops_;
  double ground = 0.0;
  for (const double* b = q; b <= end; b += 2, jacobian += 2, ground += 1.0) {
    const double x = b[0] - ground, y = b[1];
    *phi++ = x * x + y * y - 1.0;
    jacobian[0] = 2.0 * x, jacobian[1] = 2.0 * y;
  }
  for (const double* b = q; b < end; b += 2, jacobian += 4) {
    const double x = b[2] - b[0], y = b[3] - b[1];
    *phi++ = x * x + y * y - 1.0;
    jacobian[0] = -2.0 * x, jacobian[1] = -2.0 * y;
    jacobian[2] = 2.0 * x, jacobian[3] = 2.0 * y;
  }
}

void HandWritten::constraint_rates(const double*, double* phi_t) const {
  std::fill_n(phi_t, structure_.constraints, 0.0);
}

void HandWritten::constraint_accelerations(const double*, const double* v, double* gamma) const {
  const double* const end = v + 2 * loops_;
  for (const double* b = v; b <= end; b += 2) *gamma++ = 2.0 * (b[0] * b[0] + b[1] * b[1]);
  for (const double* b = v; b < end; b += 2) {
    const double x = b[2] - b[0], y = b[3] - b[1];
    *gamma++ = 2.0 * (x * x + y * y);
  }
}

void HandWritten::forces(const double*, const double*, double* force) const {
  std::copy(weight_.begin(), weight_.end(), force);
}

/// Of a rod with ends at velocities u and w: (u.u + u.w + w.w)/6.
double HandWritten::energy(const double* q, const double* v) const {
  double sum = 0.0;
  const double* const end = v + 2 * loops_;
  for (const double* b = v; b <= end; b += 2) sum += (b[0] * b[0] + b[1] * b[1]) / 6.0;
  for (const double* b = v; b < end; b += 2)
    for (int k = 0; k < 2; ++k) sum += (b[k] * b[k] + b[k] * b[k + 2] + b[k + 2] * b[k + 2]) / 6.0;
  for (std::size_t i = 1; i < weight_.size(); i += 2) sum -= weight_[i] * q[i];
  return sum;
}

mbs::State HandWritten::first_state() const {
  const int n = structure_.variables;
  mbs::State s{0.0, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
               Eigen::VectorXd::Zero(structure_.constraints)};
  for (int i = 0; i <= loops_; ++i) s.q[2 * i] = i, s.q[2 * i + 1] = 1.0, s.v[2 * i] = 1.0;
  return s;
}

}  // namespace tandem::four_bar
