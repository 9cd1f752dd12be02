// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "remembered.hpp"

#include <Eigen/QR>
#include <cmath>

namespace tandem::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Units in which each row of a map is as large as its column (E. E. Osborne, J. ACM 7, 1960).
VectorXd balance(MatrixXd map) {
  constexpr int passes = 30;
  VectorXd units = VectorXd::Ones(map.rows());
  map.diagonal().setZero();
  for (int pass = 0; pass < passes; ++pass)
    for (Index k = 0; k < map.rows(); ++k) {
      const double row = map.row(k).norm(), column = map.col(k).norm();
      if (row == 0.0 || column == 0.0) continue;
      const double unit = std::exp2(std::round(0.5 * std::log2(row / column)));
      map.row(k) /= unit, map.col(k) *= unit, units[k] *= unit;
    }
  return units;
}

}  // namespace

Remembered remembered(const MatrixXd& map) {
  constexpr double nothing = 1e-9;
  const VectorXd units = balance(map);
  Remembered all{units.cwiseInverse().asDiagonal() * map * units.asDiagonal(), units.asDiagonal(),
                 units.cwiseInverse().asDiagonal()};
  while (all.map.rows() > 0) {
    Eigen::ColPivHouseholderQR<MatrixXd> qr(all.map);
    qr.setThreshold(nothing);
    if (qr.rank() == all.map.cols()) break;
    const MatrixXd q = qr.householderQ() * MatrixXd::Identity(all.map.rows(), qr.rank());
    const MatrixXd onto = q.transpose() * all.map;
    all.back = MatrixXd(onto * all.back), all.basis = MatrixXd(all.basis * q), all.map = onto * q;
  }
  return all;
}

}  // namespace tandem::stability
