// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What makes lengths of the coordinates and constraints of a mechanism (Structure).
#include <algorithm>
#include <cmath>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {
namespace {

/// The power of 1024 by which a gradient comes nearest to 1; 1 for one that vanishes as drawn.
double scale_of(double gradient) {
  return gradient > 0.0 ? std::exp2(-10.0 * std::round(0.1 * std::log2(gradient))) : 1.0;
}

bool turns(const Relative& r) {
  return r.kind == Relative::Kind::angle || (r.kind == Relative::Kind::free && r.turns);
}

}  // namespace

/// Components of vectors and angles are multiplied with the length of the mechanism; states, which have
/// masses of 1, stay as they are. Each constraint is multiplied with what brings its gradient as drawn near
/// to 1. Powers of 1024 change no digit.
void Mechanism::add_scales() {
  const Description& in = description_;
  auto& scales = structure_.coordinate_scales;
  scales.assign(static_cast<std::size_t>(structure_.coordinates), 1.0);
  for (std::size_t e = 0; e < in.entities.size(); ++e)
    if (in.entities[e].kind == Entity::Kind::vector)
      std::fill_n(scales.begin() + numbering_.entity[e], in.dimension, structure_.length);
  for (std::size_t r = 0; r < in.relatives.size(); ++r)
    if (turns(in.relatives[r])) scales[static_cast<std::size_t>(numbering_.relative[r])] = structure_.length;
  Eigen::VectorXd phi(structure_.constraints), jacobian(structure_.jacobian_values());
  constraints(described_state().q.data(), phi.data(), jacobian.data());
  std::vector<double> largest(static_cast<std::size_t>(structure_.constraints), 0.0);
  const auto entries = structure_.jacobian.entries();
  for (std::size_t k = 0; k < entries.size(); ++k) {
    double& most = largest[static_cast<std::size_t>(entries[k].second)];
    most = std::max(most, std::abs(jacobian[static_cast<Eigen::Index>(k)]) /
                              scales[static_cast<std::size_t>(entries[k].first)]);
  }
  structure_.constraint_scales.clear();
  for (const double gradient : largest) structure_.constraint_scales.push_back(scale_of(gradient));
}

}  // namespace tandem::mbs
