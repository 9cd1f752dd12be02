// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "constraint_set.hpp"

namespace tandem::mbs {

/// An edge by the first coordinates of its ends (that of a vector begins at coordinates that are zero).
struct EdgeCoordinates {
  int to, from;
};

/// Definitions of angles theta from edge a to edge b about an axis n:
///   s cos(theta) - p sin(theta) = 0,  s = n . (a x b),  p = |n| a . b - c,
/// c = (n . a)(n . b) / |n| as drawn, which turns about the axis do not change; times a scale that makes its
/// gradients lengths of about 1. In the plane n is the third axis and c = 0. s and p are the sine and cosine
/// of theta times one length, so the gradient by theta never vanishes and no case has to be told from another
/// (where the literature changes between two equations). theta + pi is a solution as well; the one at hand
/// stays by continuity.
template <int Dimension>
class AngleSet final : public ConstraintSet {
 public:
  struct Angle {
    EdgeCoordinates a, b;
    int axis, theta;               ///< first coordinate of the axis (in space), and the angle's
    double scale, length, offset;  ///< the last two: |n| and c, times the scale
  };
  void add(const Angle& angle) { angles_.push_back(angle); }

  int size() const override { return static_cast<int>(angles_.size()); }
  std::vector<int> coordinates(int equation) const override {
    const Angle& angle = angles_[equation];
    std::vector<int> list;
    for (const int first : {angle.a.to, angle.a.from, angle.b.to, angle.b.from})
      for (int d = 0; d < Dimension; ++d) list.push_back(first + d);
    if constexpr (Dimension == 3) list.insert(list.end(), {angle.axis, angle.axis + 1, angle.axis + 2});
    list.push_back(angle.theta);
    return list;
  }

  /// The edges may share points, so entries add up.
  void values(const double* q, double* phi, double* jacobian) const override {
    for (const int to : to_) jacobian[to] = 0.0;
    const int* to = to_.data();
    phi += first_;
    for (const Angle& angle : angles_) {
      const Vector a = edge(q, angle.a), b = edge(q, angle.b), n = axis(q, angle);
      const double cosine = std::cos(q[angle.theta]), sine = std::sin(q[angle.theta]);
      const double s = n.dot(a.cross(b)), p = angle.length * a.dot(b) - angle.offset;
      *phi++ = s * cosine - p * sine;
      const Vector by_a = cosine * b.cross(n) - angle.length * sine * b,
                   by_b = cosine * n.cross(a) - angle.length * sine * a,
                   by_n = angle.scale * cosine * a.cross(b);
      for (int d = 0; d < Dimension; ++d, ++to) {
        jacobian[to[0]] += by_a[d], jacobian[to[Dimension]] -= by_a[d];
        jacobian[to[2 * Dimension]] += by_b[d], jacobian[to[3 * Dimension]] -= by_b[d];
        if constexpr (Dimension == 3) jacobian[to[4 * Dimension]] += by_n[d];
      }
      to += (Dimension == 3 ? 4 : 3) * Dimension;
      jacobian[*to++] -= s * sine + p * cosine;
    }
  }

  void accelerations(const double* q, const double* v, double* gamma) const override {
    gamma += first_;
    for (const Angle& angle : angles_) {
      const Vector a = edge(q, angle.a), b = edge(q, angle.b), n = axis(q, angle), av = edge(v, angle.a),
                   bv = edge(v, angle.b), nv = axis_rate(v, angle);
      const double cosine = std::cos(q[angle.theta]), sine = std::sin(q[angle.theta]), w = v[angle.theta];
      const double s = n.dot(a.cross(b)), p = angle.length * a.dot(b) - angle.offset;
      const double sv = nv.dot(a.cross(b)) + n.dot(av.cross(b) + a.cross(bv)),
                   pv = angle.length * (av.dot(b) + a.dot(bv));
      const double sa = 2.0 * (nv.dot(av.cross(b) + a.cross(bv)) + n.dot(av.cross(bv))),
                   pa = 2.0 * angle.length * av.dot(bv);
      *gamma++ =
          sa * cosine - pa * sine - 2.0 * w * (sv * sine + pv * cosine) - w * w * (s * cosine - p * sine);
    }
  }

 private:
  using Vector = Eigen::Vector3d;
  static Vector edge(const double* q, const EdgeCoordinates& e) {
    Vector result = Vector::Zero();
    for (int d = 0; d < Dimension; ++d) result[d] = q[e.to + d] - q[e.from + d];
    return result;
  }
  static Vector axis(const double* q, const Angle& angle) {
    if constexpr (Dimension == 2) return angle.scale * Vector::UnitZ();
    return angle.scale * Vector(q[angle.axis], q[angle.axis + 1], q[angle.axis + 2]);
  }
  static Vector axis_rate(const double* v, const Angle& angle) {
    return Dimension == 2 ? Vector(Vector::Zero()) : axis(v, angle);
  }

  std::vector<Angle> angles_;
};

}  // namespace tandem::mbs
