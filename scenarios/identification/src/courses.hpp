// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/LU>
#include <cmath>

#include "tandem/identification/linear_model.hpp"

namespace tandem::identification {

using Courses = Eigen::Matrix<double, 5, 5>;

/// Column j: the coefficients of the polynomial, in parts of a step, that is 1 at places[j] and 0 at the others.
inline Courses courses() {
  Courses powers;
  for (Eigen::Index j = 0; j < 5; ++j)
    for (Eigen::Index k = 0; k < 5; ++k)
      powers(j, k) = std::pow(places[static_cast<std::size_t>(j)], static_cast<double>(k));
  return powers.inverse();
}

}  // namespace tandem::identification
