// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "off.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem::mbs {
namespace {

Eigen::Vector2d value(const Forms& forms, const double* q) {
  Eigen::Vector2d sums;
  for (std::size_t k = 0; k < 2; ++k) {
    double& sum = sums[static_cast<Eigen::Index>(k)] = forms[k].constant;
    for (const auto& [i, c] : forms[k].terms) sum += c * q[i];
  }
  return sums;
}

}  // namespace

Off off_of_distance(double l, double phi) {
  return {l * (std::sqrt(std::max(0.0, 1.0 + phi / l)) - 1.0), 0.5};
}

OffOf off_of_length(int s, double scale) {
  return [=](const double* q, double phi) {
    const double square = q[s] * q[s] + phi / scale;
    return Off{std::sqrt(std::max(0.0, square)) - q[s], 0.5 / (scale * q[s])};
  };
}

OffOf off_of_angle(Forms a, Forms b, double phi0, double scale) {
  return [a = std::move(a), b = std::move(b), phi0, scale](const double* q, double phi) {
    const Eigen::Vector2d from = value(a, q), to = value(b, q);
    const double cross = from[0] * to[1] - from[1] * to[0], dot = from.dot(to);
    const double cosine = scale * (dot * std::cos(phi0) + cross * std::sin(phi0));
    return Off{std::atan2(phi, cosine), 1.0 / cosine};
  };
}

}  // namespace tandem::mbs
