// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

namespace tandem::mbs {

/// An edge by the first coordinates of its ends (that of a vector begins at coordinates that are zero).
struct EdgeCoordinates {
  int to, from;
};

/// Those of the ends of both: of each end all coordinates, one behind the other.
template <int Dimension>
std::vector<int> coordinates_of(const EdgeCoordinates& a, const EdgeCoordinates& b) {
  std::vector<int> list;
  for (const int first : {a.to, a.from, b.to, b.from})
    for (int d = 0; d < Dimension; ++d) list.push_back(first + d);
  return list;
}

/// In the plane the third number is zero.
template <int Dimension>
Eigen::Vector3d edge(const double* q, const EdgeCoordinates& e) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int d = 0; d < Dimension; ++d) result[d] = q[e.to + d] - q[e.from + d];
  return result;
}

}  // namespace tandem::mbs
