// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <vector>

#include "tandem/error.hpp"

namespace tandem::mechanisms {

/// The references are computed with more digits than they are given in: a double pendulum multiplies an early
/// error by two thousand within ten seconds.
using Real = long double;
using Vector2 = Eigen::Matrix<Real, 2, 1>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;

inline constexpr Real gravity = 9.81L;  ///< [m/s^2]

/// The solution of y' = rates(y) at the time t >= 0 [s] from y at 0, by the Runge-Kutta method of order 8 of
/// E. Fehlberg (NASA TR R-287, 1968) with its own choice of steps, each to an error of 1e-18 of y and y'.
template <std::size_t N, class Rates>
std::array<Real, N> advance(std::array<Real, N> y, double t, const Rates& rates) {
  if (!(t >= 0.0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("time of a reference is {} s; allowed is from 0 s", t));
  namespace ode = boost::numeric::odeint;
  using State = std::vector<Real>;
  const auto right_side = [&](const State& state, State& rate, Real) {
    std::copy_n(state.begin(), N, y.begin());
    std::ranges::copy(rates(y), rate.begin());
  };
  State state(y.begin(), y.end());
  const auto method = ode::make_controlled<ode::runge_kutta_fehlberg78<State, Real>>(1e-18L, 1e-18L);
  ode::integrate_adaptive(method, right_side, state, Real{0}, Real{t}, Real{1e-4L});
  std::copy_n(state.begin(), N, y.begin());
  return y;
}

}  // namespace tandem::mechanisms
