// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/QR>

// Dense algebra of small matrices while a mechanism is set up or looked at. It is compiled in dense.cpp
// alone: each of Eigen's decompositions takes ten seconds to compile in each file that has one, with
// sanitizers thirty.
extern template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

namespace tandem::mbs::dense {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Qr = Eigen::ColPivHouseholderQR<MatrixXd>;

/// A x = b in the sense of least squares.
VectorXd solve(const Qr& a, const VectorXd& b);
MatrixXd solve(const Qr& a, const MatrixXd& b);
/// Orthonormal columns that every column of A is orthogonal to.
MatrixXd complement(const Qr& a);
/// Of those in the sense of least squares the shortest x.
VectorXd shortest_solution(const MatrixXd& a, const VectorXd& b);
/// A x = b by LU with row interchanges.
VectorXd solve_by_lu(const MatrixXd& a, const VectorXd& b);
/// Ascending.
VectorXd symmetric_eigenvalues(const MatrixXd& a);
/// Of any square matrix of a row and more; each vector is of length 1. Throws Error where it is not found.
struct Spectrum {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
Spectrum spectrum(const MatrixXd& a);
/// R^T A R.
MatrixXd reduced(const MatrixXd& a, const MatrixXd& r);

}  // namespace tandem::mbs::dense
