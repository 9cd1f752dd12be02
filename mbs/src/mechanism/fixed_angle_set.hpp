// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "constraint_set.hpp"
#include "edge_coordinates.hpp"

namespace tandem::mbs {

/// Constant angles in space, of edges that may change their lengths:
///   a . b - |a| |b| cos(angle) = 0, times a scale that makes its gradients lengths of about 1.
/// Its gradient vanishes where the angle is 0 or pi.
class FixedAngleSet final : public ConstraintSet {
 public:
  struct Angle {
    EdgeCoordinates a, b;
    double angle, scale;
  };
  void add(const Angle& angle) { angles_.push_back(angle); }

  int size() const override { return static_cast<int>(angles_.size()); }
  std::vector<int> coordinates(int equation) const override {
    return coordinates_of<3>(angles_[equation].a, angles_[equation].b);
  }

  /// The edges may share points, so entries add up.
  void values(const double* q, double* phi, double* jacobian) const override {
    for (const int to : to_) jacobian[to] = 0.0;
    const int* to = to_.data();
    phi += first_;
    for (const Angle& angle : angles_) {
      const Vector a = edge<3>(q, angle.a), b = edge<3>(q, angle.b);
      const double la = a.norm(), lb = b.norm(), cosine = std::cos(angle.angle);
      *phi++ = angle.scale * (a.dot(b) - la * lb * cosine);
      const Vector by_a = angle.scale * (b - lb / la * cosine * a),
                   by_b = angle.scale * (a - la / lb * cosine * b);
      for (int d = 0; d < 3; ++d, ++to) {
        jacobian[to[0]] += by_a[d], jacobian[to[3]] -= by_a[d];
        jacobian[to[6]] += by_b[d], jacobian[to[9]] -= by_b[d];
      }
      to += 9;
    }
  }

  void accelerations(const double* q, const double* v, double* gamma) const override {
    gamma += first_;
    for (const Angle& angle : angles_) {
      const Vector a = edge<3>(q, angle.a), b = edge<3>(q, angle.b), av = edge<3>(v, angle.a),
                   bv = edge<3>(v, angle.b);
      const double la = a.norm(), lb = b.norm(), rate_a = a.dot(av) / la, rate_b = b.dot(bv) / lb;
      const double square = (av.squaredNorm() - rate_a * rate_a) * lb / la + 2.0 * rate_a * rate_b +
                            (bv.squaredNorm() - rate_b * rate_b) * la / lb;
      *gamma++ = angle.scale * (2.0 * av.dot(bv) - square * std::cos(angle.angle));
    }
  }

  Off off(int equation, const double* q, double phi) const override {
    const Angle& angle = angles_[equation];
    const double size = angle.scale * edge<3>(q, angle.a).norm() * edge<3>(q, angle.b).norm(),
                 cosine = std::clamp(std::cos(angle.angle) + phi / size, -1.0, 1.0);
    return {std::acos(cosine) - angle.angle, -1.0 / (size * std::sin(angle.angle))};
  }

 private:
  using Vector = Eigen::Vector3d;
  std::vector<Angle> angles_;
};

}  // namespace tandem::mbs
