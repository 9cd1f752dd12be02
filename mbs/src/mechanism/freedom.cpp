// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/freedom.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseQR>
#include <algorithm>

#include "scaled.hpp"

namespace tandem::mbs {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double rounding = 1e-12;  ///< of the longest column: what an equation that holds nothing leaves

/// Phi_q^T with columns of length 1, so that one threshold serves them all, or of nothing.
Sparse gradients(Model& of, State s) {
  Scaled model(of);
  model.scale(s);
  const Structure& structure = model.structure();
  std::vector<double> phi(static_cast<std::size_t>(structure.constraints)),
      jacobian(static_cast<std::size_t>(structure.jacobian_values()));
  model.at_time(s.time);
  model.constraints(s.q.data(), phi.data(), jacobian.data());
  const Pattern& p = structure.jacobian;
  Sparse a = Eigen::Map<const Sparse>(p.rows(), p.columns(), p.size(), p.starts().data(), p.indices().data(),
                                      jacobian.data());
  double longest = 0.0;
  for (int c = 0; c < a.cols(); ++c) longest = std::max(longest, a.col(c).norm());
  for (int c = 0; c < a.cols(); ++c) {
    const double length = a.col(c).norm();
    a.col(c) *= length > rounding * longest ? 1.0 / length : 0.0;
  }
  a.makeCompressed();
  return a;
}

/// No pivot of A^T A comes near rounding: seen in milliseconds where the QR decomposition takes seconds (4000
/// rods). What falls short of it is not dependent yet.
bool plainly_independent(const Sparse& a) {
  const Eigen::SimplicialLDLT<Sparse> factors(Sparse(a.transpose() * a));
  return factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 1e-10;
}

}  // namespace

Freedom freedom(Model& model, const State& state) {
  const Structure& structure = model.structure();
  Freedom result{0, structure.variables, {}};
  if (structure.constraints == 0) return result;
  const Sparse a = gradients(model, state);
  if (plainly_independent(a)) {
    result.rank = structure.constraints;
    result.degrees = structure.variables - result.rank;
    return result;
  }
  Eigen::SparseQR<Sparse, Eigen::COLAMDOrdering<int>> qr;
  qr.setPivotThreshold(1e-9);
  qr.compute(a);
  result.rank = static_cast<int>(qr.rank());
  result.degrees = structure.variables - result.rank;
  for (int k = result.rank; k < structure.constraints; ++k)
    result.redundant.push_back(qr.colsPermutation().indices()[k]);
  std::sort(result.redundant.begin(), result.redundant.end());
  return result;
}

}  // namespace tandem::mbs
