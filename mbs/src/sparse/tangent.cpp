// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/tangent.hpp"

#include <algorithm>
#include <utility>

#include "check_memory.hpp"

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

bool couples_state(const Structure& s, int row, int column) {
  return std::any_of(s.states.begin(), s.states.end(), [&](int i) { return i == row || i == column; });
}

/// All that couples the states to others is left out.
Pattern without_states(const Structure& s, Pattern all) {
  if (s.states.empty()) return all;
  auto entries = all.entries();
  std::erase_if(entries,
                [&](const auto& e) { return e.first != e.second && couples_state(s, e.first, e.second); });
  return {s.variables, s.variables, std::move(entries)};
}

Pattern tangent_pattern(const Structure& s) {
  const Pattern forces = unite(s.mass.pattern, s.stiffness);
  return without_states(s, unite(unite(forces, outer_products(s.jacobian)), diagonal(s.variables)));
}

Layout prepared_layout(LinearSolver& solver, const Pattern& pattern) {
  solver.analyze(pattern);
  return solver.layout();
}

}  // namespace

Tangent::Tangent(const Structure& structure, std::unique_ptr<LinearSolver> solver)
    : solver_(std::move(solver)),
      pattern_(tangent_pattern(structure)),
      layout_(prepared_layout(*solver_, pattern_)),
      update_(structure.jacobian, layout_),
      states_(structure, layout_),
      mass_(layout_.size()),
      values_(layout_.size() + states_.size()) {
  for (std::size_t e = 0; e < layout_.size(); ++e) {
    const auto [row, column] = layout_[e];
    if (row < 0) continue;
    if (const int k = structure.mass.pattern.find(row, column); k >= 0) mass_[e] = structure.mass.values[k];
    if (row != column && couples_state(structure, row, column)) continue;  // a band has room for it
    if (const int k = structure.stiffness.find(row, column); k >= 0)
      from_.push_back(k), to_.push_back(static_cast<int>(e));
  }
  base_ = mass_;
}

void Tangent::remember(std::vector<double>& to) const {
  to.insert(to.end(), values_.begin(), values_.end());
  solver_->remember(to);
}

void Tangent::recall(std::span<const double> memory) {
  check_memory(memory.size() >= values_.size());
  solver_->recall(memory.subspan(values_.size()));
  std::copy_n(memory.begin(), values_.size(), values_.begin());
  if (!solver_->in_place()) solver_->factorize(values_.data());
}

void Tangent::assemble(const ModelMatrices& at, const TangentFactors& factors) {
  if (!to_.empty()) {
    base_ = mass_;
    for (std::size_t k = 0; k < to_.size(); ++k)
      base_[to_[k]] += factors.stiffness * at.stiffness[from_[k]] + factors.damping * at.damping[from_[k]];
  }
  states_.assemble(at, factors, base_.data(), values_.data() + layout_.size());
  update_.run(at.jacobian.data(), factors.penalty, base_.data(), values_.data());
}

void Tangent::solve(double* b) {
  states_.reduce(values_.data() + layout_.size(), b);
  solver_->solve(b);
  states_.expand(values_.data() + layout_.size(), b);
}

}  // namespace tandem::mbs
