// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/modes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../dense.hpp"
#include "linear_forces.hpp"
#include "scaled.hpp"
#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;

/// [0 1; -M^-1 K, -M^-1 C].
MatrixXd first_order(const MatrixXd& m, const MatrixXd& k, const MatrixXd& c) {
  const Eigen::LLT<MatrixXd> mass(m);
  if (mass.info() != Eigen::Success || mass.rcond() < 1e-14)
    throw Error(ErrorCode::numerical,
                "the constraints leave a motion without mass; allowed is a mechanism where each has some");
  const auto n = m.rows();
  MatrixXd a = MatrixXd::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -mass.solve(k);
  a.bottomRightCorner(n, n) = -mass.solve(c);
  if (!a.allFinite())
    throw Error(ErrorCode::numerical,
                "stiffness or damping is not finite where it stands; allowed are inputs with values and "
                "forces that are finite");
  return a;
}

/// In the model's own units, with the largest entry 1.
Eigen::VectorXcd shape(const Scaled& model, Eigen::VectorXcd scaled) {
  for (int c = 0; c < scaled.size(); ++c) scaled[c] /= model.coordinate_scale(c);
  Eigen::Index largest = 0;
  scaled.cwiseAbs().maxCoeff(&largest);
  return scaled / scaled[largest];
}

}  // namespace

double Mode::frequency() const { return std::abs(p) / (2.0 * std::numbers::pi); }

double Mode::damping() const { return std::abs(p) > 0.0 ? -p.real() / std::abs(p) : 0.0; }

std::vector<Mode> modes(Model& of, const State& at) {
  Scaled model(of);
  model.at_time(at.time);
  DenseTerms terms(model);
  State s = at;
  model.scale(s);
  terms.evaluate(s.q, s.v);
  if (s.lambda.size() > 0) s.lambda = dense::shortest_solution(terms.gradients, terms.force);
  const MatrixXd r = free_motions(terms.gradients);
  if (r.cols() == 0) return {};
  const MatrixXd k = dense::reduced(terms.stiffness(s), r), c = dense::reduced(terms.damping(s), r),
                 m = dense::reduced(terms.mass(), r);
  const auto [values, vectors] = dense::spectrum(first_order(m, k, c));
  std::vector<Mode> all;
  for (int i = 0; i < values.size(); ++i) {
    if (values[i].imag() < 0.0) continue;
    all.push_back({values[i], shape(model, r * vectors.col(i).head(r.cols()))});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Mode& a, const Mode& b) { return std::abs(a.p) < std::abs(b.p); });
  return all;
}

}  // namespace tandem::mbs
