// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "functions/double_pendulum.hpp"

#include <algorithm>
#include <utility>

namespace tandem::functions {
namespace {

mbs::Pattern dense(int rows, int columns) {
  std::vector<std::pair<int, int>> entries;
  for (int k = 0; k < rows * columns; ++k) entries.emplace_back(k % rows, k / rows);
  return {rows, columns, std::move(entries)};
}

double mass(int i, int j) {
  constexpr double rods[2][2] = {{2.0 / 3, 1.0 / 6}, {1.0 / 6, 1.0 / 3}};  // 1/6 [2 1; 1 2] of each
  return i % 2 == j % 2 ? rods[i / 2][j / 2] : 0.0;
}

}  // namespace

DoublePendulum::DoublePendulum() {
  structure_.coordinates = structure_.variables = 4;
  structure_.constraints = 2;
  structure_.mass = {dense(4, 4), std::vector<double>(16)};
  for (int k = 0; k < 16; ++k) structure_.mass.values[static_cast<std::size_t>(k)] = mass(k % 4, k / 4);
  structure_.jacobian = dense(4, 2);
  structure_.stiffness = mbs::Pattern(4, 4, {});
  structure_.variable_names = {"elbow_x", "elbow_y", "tip_x", "tip_y"};
  structure_.constraint_names = {"first rod", "second rod"};
}

mbs::State DoublePendulum::level() {
  return {0.0, Eigen::Vector4d(1, 0, 2, 0), Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero(),
          Eigen::Vector2d::Zero()};
}

void DoublePendulum::constraints(const double* q, double* phi, double* jacobian) const {
  const double x = q[2] - q[0], y = q[3] - q[1];
  phi[0] = q[0] * q[0] + q[1] * q[1] - 1.0;
  phi[1] = x * x + y * y - 1.0;
  const double values[] = {2 * q[0], 2 * q[1], 0.0, 0.0, -2 * x, -2 * y, 2 * x, 2 * y};
  std::copy(std::begin(values), std::end(values), jacobian);
}

void DoublePendulum::constraint_rates(const double*, double* phi_t) const { phi_t[0] = phi_t[1] = 0.0; }

void DoublePendulum::constraint_accelerations(const double*, const double* v, double* gamma) const {
  const double x = v[2] - v[0], y = v[3] - v[1];
  gamma[0] = 2 * (v[0] * v[0] + v[1] * v[1]);
  gamma[1] = 2 * (x * x + y * y);
}

void DoublePendulum::forces(const double*, const double*, double* force) const {
  force[0] = force[2] = 0.0;
  force[1] = -9.81;
  force[3] = -9.81 * 0.5;
}

double DoublePendulum::energy(const double* q, const double* v) const {
  const Eigen::Map<const Eigen::Matrix4d> m(structure_.mass.values.data());
  const Eigen::Map<const Eigen::Vector4d> rate(v);
  return 0.5 * rate.dot(m * rate) + 9.81 * (q[1] + 0.5 * q[3]);
}

}  // namespace tandem::functions
