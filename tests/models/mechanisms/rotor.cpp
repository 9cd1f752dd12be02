// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/rotor.hpp"

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {
namespace {

using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Turn = Eigen::AngleAxis<Real>;

constexpr Real momentum = 2;

/// The principal axes where e3 has that angle from z and that azimuth, and e2 leads the horizontal by spin.
Matrix3 axes(Real nutation, Real azimuth, Real spin) {
  return (Turn(azimuth, Vector3::UnitZ()) * Turn(nutation, Vector3::UnitY()) * Turn(spin, Vector3::UnitZ()))
      .toRotationMatrix();
}

RotorState state(const Matrix3& axes, const Vector3& inertia) {
  const Vector3 components = (axes.transpose() * Vector3(0, 0, momentum)).cwiseQuotient(inertia);
  return {axes.cast<double>(), (axes * components).cast<double>()};
}

const Vector3 three_inertias(0.3L, 0.4L, 0.5L);

/// Of the angular velocity along the principal axes, Landau and Lifshitz (37.10) with the signs of the start.
Vector3 components(Real t) {
  constexpr Real tilt = 0.6L;
  const Real i1 = three_inertias[0], i2 = three_inertias[1], i3 = three_inertias[2];
  const Real along = momentum * std::cos(tilt), across = momentum * std::sin(tilt);
  const Real twice_energy = across * across / i1 + along * along / i3;
  const Real low = twice_energy * i3 - momentum * momentum, high = momentum * momentum - twice_energy * i1;
  const Real k = std::sqrt((i2 - i1) * low / ((i3 - i2) * high));
  Real cn = 0;  // dn from sn, as that of Boost 1.74 loses digits where cn is small
  const Real sn = boost::math::jacobi_elliptic(k, std::sqrt((i3 - i2) * high / (i1 * i2 * i3)) * t, &cn);
  return {-across / i1 * cn, -std::sqrt(low / (i2 * (i3 - i2))) * sn,
          along / i3 * std::sqrt(1 - k * k * sn * sn)};
}

/// Landau and Lifshitz, sect. 37, the rate of phi.
Real azimuth_rate(const Vector3& components) {
  const Vector3 momenta = components.cwiseProduct(three_inertias);
  const Eigen::Matrix<Real, 2, 1> level = momenta.head<2>();
  return momentum * level.dot(components.head<2>()) / level.squaredNorm();
}

}  // namespace

RotorState rotor(double t) {
  constexpr Real tilt = 0.4L, i1 = 0.3L, i3 = 0.5L;
  const Real spin = momentum * std::cos(tilt) * (1 / i3 - 1 / i1);
  return state(axes(tilt, momentum / i1 * t, spin * t), {i1, i1, i3});
}

RotorState asymmetric_rotor(double t) {
  const auto rate = [](Real at) { return azimuth_rate(components(at)); };
  const Real azimuth =
      boost::math::quadrature::gauss_kronrod<Real, 31>::integrate(rate, Real{0}, Real{t}, 20, Real{1e-16L});
  const Vector3 momenta = components(t).cwiseProduct(three_inertias);
  const Real nutation = std::atan2(std::hypot(momenta[0], momenta[1]), momenta[2]);
  return state(axes(nutation, azimuth, std::atan2(momenta[1], -momenta[0])), three_inertias);
}

}  // namespace tandem::mechanisms
