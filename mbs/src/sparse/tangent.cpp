// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/tangent.hpp"

#include <utility>

namespace tandem::mbs {
namespace {

/// The entries of A A^T, A of compressed columns.
Pattern outer_products(const Pattern& a) {
  std::vector<std::pair<int, int>> entries;
  for (int c = 0; c < a.columns(); ++c)
    for (int left = a.starts()[c]; left < a.starts()[c + 1]; ++left)
      for (int right = a.starts()[c]; right < a.starts()[c + 1]; ++right)
        entries.emplace_back(a.indices()[left], a.indices()[right]);
  return {a.rows(), a.rows(), std::move(entries)};
}

Pattern diagonal(int size) {
  std::vector<std::pair<int, int>> entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i);
  return {size, size, std::move(entries)};
}

Pattern tangent_pattern(const Structure& s, bool lower) {
  const Pattern forces = unite(s.mass.pattern, s.stiffness);
  const Pattern whole = unite(unite(forces, outer_products(s.jacobian)), diagonal(s.variables));
  return lower ? whole.lower() : whole;
}

}  // namespace

Tangent::Tangent(const Structure& structure, std::unique_ptr<LinearSolver> solver)
    : solver_(std::move(solver)),
      pattern_(tangent_pattern(structure, solver_->lower())),
      update_(structure.jacobian, pattern_),
      mass_(static_cast<std::size_t>(pattern_.size())),
      values_(mass_.size()) {
  const auto mass = positions(structure.mass.pattern, pattern_),
             stiffness = positions(structure.stiffness, pattern_);
  for (std::size_t k = 0; k < mass.size(); ++k)
    if (mass[k] >= 0) mass_[mass[k]] = structure.mass.values[k];
  for (std::size_t k = 0; k < stiffness.size(); ++k)
    if (stiffness[k] >= 0) from_.push_back(static_cast<int>(k)), to_.push_back(stiffness[k]);
  base_ = mass_;
  solver_->analyze(pattern_);
}

void Tangent::assemble(const ModelMatrices& at, const TangentFactors& factors) {
  if (!to_.empty()) {
    base_ = mass_;
    for (std::size_t k = 0; k < to_.size(); ++k)
      base_[to_[k]] += factors.stiffness * at.stiffness[from_[k]] + factors.damping * at.damping[from_[k]];
  }
  update_.run(at.jacobian.data(), factors.penalty, base_.data(), values_.data());
}

}  // namespace tandem::mbs
