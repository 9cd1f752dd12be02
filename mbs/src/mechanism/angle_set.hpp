// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "constraint_set.hpp"
#include "edge_coordinates.hpp"

namespace tandem::mbs {

/// Definitions of angles theta from edge a to edge b about an axis n:
///   s cos(theta) - p sin(theta) = 0,  s = n . (a x b),  p = |n| a . b - (n . a)(n . b) / |n|,
/// |n| as drawn; times a scale that makes its gradients lengths of about 1. In the plane n is the third axis,
/// along which edges have no part. s and p are the sine and cosine of theta times one length, so the gradient
/// by theta never vanishes and no case has to be told from another (where the literature changes between two
/// equations). theta + pi is a solution as well; the one at hand stays by continuity.
template <int Dimension>
class AngleSet final : public ConstraintSet {
 public:
  struct Angle {
    EdgeCoordinates a, b;
    int axis, theta;       ///< first coordinate of the axis (in space), and the angle's
    double scale, length;  ///< the second: |n| times the scale
  };
  void add(const Angle& angle) { angles_.push_back(angle); }

  int size() const override { return static_cast<int>(angles_.size()); }
  std::vector<int> coordinates(int equation) const override {
    const Angle& angle = angles_[equation];
    std::vector<int> list = coordinates_of<Dimension>(angle.a, angle.b);
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
      const Turn at = turn(q, angle);
      const double cosine = std::cos(q[angle.theta]), sine = std::sin(q[angle.theta]);
      *phi++ = at.s * cosine - at.p * sine;
      const Vector by_a = cosine * at.b.cross(at.n) - sine * (angle.length * at.b - at.nb * at.n),
                   by_b = cosine * at.n.cross(at.a) - sine * (angle.length * at.a - at.na * at.n),
                   by_n = angle.scale * (cosine * at.a.cross(at.b) + sine * (at.nb * at.a + at.na * at.b));
      for (int d = 0; d < Dimension; ++d, ++to) {
        jacobian[to[0]] += by_a[d], jacobian[to[Dimension]] -= by_a[d];
        jacobian[to[2 * Dimension]] += by_b[d], jacobian[to[3 * Dimension]] -= by_b[d];
        if constexpr (Dimension == 3) jacobian[to[4 * Dimension]] += by_n[d];
      }
      to += (Dimension == 3 ? 4 : 3) * Dimension;
      jacobian[*to++] -= at.s * sine + at.p * cosine;
    }
  }

  void accelerations(const double* q, const double* v, double* gamma) const override {
    gamma += first_;
    for (const Angle& angle : angles_) {
      const Turn at = turn(q, angle);
      const Vector av = edge<Dimension>(v, angle.a), bv = edge<Dimension>(v, angle.b),
                   nv = axis_rate(v, angle);
      const double cosine = std::cos(q[angle.theta]), sine = std::sin(q[angle.theta]), w = v[angle.theta];
      const double na_rate = (nv.dot(at.a) + at.n.dot(av)) / angle.length,
                   nb_rate = (nv.dot(at.b) + at.n.dot(bv)) / angle.length;
      const double sv = nv.dot(at.a.cross(at.b)) + at.n.dot(av.cross(at.b) + at.a.cross(bv)),
                   pv = angle.length * (av.dot(at.b) + at.a.dot(bv) - na_rate * at.nb - at.na * nb_rate);
      const double sa = 2.0 * (nv.dot(av.cross(at.b) + at.a.cross(bv)) + at.n.dot(av.cross(bv))),
                   pa = 2.0 * (angle.length * (av.dot(bv) - na_rate * nb_rate) - nv.dot(av) * at.nb -
                               nv.dot(bv) * at.na);
      *gamma++ = sa * cosine - pa * sine - 2.0 * w * (sv * sine + pv * cosine) -
                 w * w * (at.s * cosine - at.p * sine);
    }
  }

  Off off(int equation, const double* q, double phi) const override {
    const Angle& angle = angles_[equation];
    const Turn at = turn(q, angle);
    const double along = at.s * std::sin(q[angle.theta]) + at.p * std::cos(q[angle.theta]);
    return {std::atan2(phi, along), 1.0 / along};
  }

 private:
  using Vector = Eigen::Vector3d;
  static Vector axis(const double* q, const Angle& angle) {
    if constexpr (Dimension == 2) return angle.scale * Vector::UnitZ();
    return angle.scale * Vector(q[angle.axis], q[angle.axis + 1], q[angle.axis + 2]);
  }
  static Vector axis_rate(const double* v, const Angle& angle) {
    return Dimension == 2 ? Vector(Vector::Zero()) : axis(v, angle);
  }

  /// Edges, axis times the scale, s and p, and the parts of the edges along the axis.
  struct Turn {
    Vector a, b, n;
    double s, p, na, nb;
  };
  static Turn turn(const double* q, const Angle& angle) {
    const Vector a = edge<Dimension>(q, angle.a), b = edge<Dimension>(q, angle.b), n = axis(q, angle);
    const double na = n.dot(a) / angle.length, nb = n.dot(b) / angle.length;
    return {a, b, n, n.dot(a.cross(b)), angle.length * (a.dot(b) - na * nb), na, nb};
  }

  std::vector<Angle> angles_;
};

}  // namespace tandem::mbs
