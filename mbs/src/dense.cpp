// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <string>

#include "tandem/error.hpp"

template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

namespace tandem::mbs::dense {

VectorXd solve(const Qr& a, const VectorXd& b) { return a.solve(b); }
MatrixXd solve(const Qr& a, const MatrixXd& b) { return a.solve(b); }

MatrixXd complement(const Qr& a) {
  const auto n = a.rows();
  const MatrixXd q = a.householderQ() * MatrixXd::Identity(n, n);
  return q.rightCols(n - a.rank());
}

VectorXd shortest_solution(const MatrixXd& a, const VectorXd& b) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(a).solve(b);
}

VectorXd solve_by_lu(const MatrixXd& a, const VectorXd& b) { return a.partialPivLu().solve(b); }

VectorXd symmetric_eigenvalues(const MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

Spectrum spectrum(const MatrixXd& a) {
  const Eigen::EigenSolver<MatrixXd> solver(a);
  if (solver.info() != Eigen::Success)
    throw Error(ErrorCode::numerical, "the eigenvalues of a matrix of " + std::to_string(a.rows()) +
                                          " rows are not found by Eigen's QR algorithm");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

MatrixXd reduced(const MatrixXd& a, const MatrixXd& r) { return r.transpose() * a * r; }

}  // namespace tandem::mbs::dense
