// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include "tandem/error.hpp"

namespace tandem::stability {

/// Of f about z by a change of one of its numbers: the central difference, or that to the side to which z can be moved
/// (an input that is 0 at the least).
template <class Function>
Eigen::VectorXd difference(const Function& f, const Eigen::VectorXd& z, Eigen::Index k, double change) {
  const auto at = [&](double by) { return Eigen::VectorXd(f(z + by * Eigen::VectorXd::Unit(z.size(), k))); };
  const auto ahead = [&] { return Eigen::VectorXd((at(change) - at(0.0)) / change); };
  const auto back = [&] { return Eigen::VectorXd((at(0.0) - at(-change)) / change); };
  try {
    return (at(change) - at(-change)) / (2.0 * change);
  } catch (const Error&) {
  }
  try {
    return ahead();
  } catch (const Error&) {
    return back();
  }
}

}  // namespace tandem::stability
