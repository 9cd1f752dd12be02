// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/condensed_states.hpp"

#include <algorithm>

#include "tandem/mbs/sparse/tangent.hpp"

namespace tandem::mbs {

CondensedStates::CondensedStates(const Structure& s, const Layout& layout) {
  const auto is_state = [&](int i) {
    return std::find(s.states.begin(), s.states.end(), i) != s.states.end();
  };
  for (const int state : s.states) {
    One one{state,
            s.mass.values[static_cast<std::size_t>(s.mass.pattern.find(state, state))],
            s.stiffness.find(state, state),
            0,
            {},
            {}};
    std::vector<int> number(static_cast<std::size_t>(s.variables), -1);
    for (int i = 0; i < s.variables; ++i) {
      const int column = s.stiffness.find(i, state), row = s.stiffness.find(state, i);
      if (is_state(i) || (column < 0 && row < 0)) continue;
      number[static_cast<std::size_t>(i)] = static_cast<int>(one.couplings.size());
      one.couplings.push_back({i, column, row});
    }
    for (std::size_t e = 0; e < layout.size(); ++e) {
      const auto [i, j] = layout[e];
      if (i < 0) continue;
      if (i == state && j == state) one.at = e;
      const int row = number[static_cast<std::size_t>(i)], column = number[static_cast<std::size_t>(j)];
      if (row >= 0 && column >= 0) one.fill.push_back({e, row, column});
    }
    size_ += 1 + 2 * one.couplings.size();
    all_.push_back(std::move(one));
  }
}

/// Kept of each state: d, then its column, then its row.
void CondensedStates::assemble(const ModelMatrices& at, const TangentFactors& f, double* base,
                               double* kept) const {
  const auto value = [&](int k) {
    if (k < 0) return 0.0;
    const auto position = static_cast<std::size_t>(k);
    return f.damping * at.damping[position] + f.stiffness * at.stiffness[position];
  };
  for (const One& one : all_) {
    const std::size_t n = one.couplings.size();
    const double d = base[one.at] = kept[0] = one.mass + value(one.diagonal);
    double *const column = kept + 1, *const row = column + n;
    for (std::size_t k = 0; k < n; ++k) {
      column[k] = value(one.couplings[k].in_column);
      row[k] = value(one.couplings[k].in_row);
    }
    for (const Fill& fill : one.fill)
      base[fill.to] -= 0.5 / d * (column[fill.row] * row[fill.column] + column[fill.column] * row[fill.row]);
    kept = row + n;
  }
}

void CondensedStates::reduce(const double* kept, double* b) const {
  for (const One& one : all_) {
    const double part = b[one.variable] / kept[0];
    ++kept;
    for (const Coupling& c : one.couplings) b[c.variable] -= *kept++ * part;
    kept += one.couplings.size();
  }
}

void CondensedStates::expand(const double* kept, double* x) const {
  for (const One& one : all_) {
    const double d = kept[0];
    kept += 1 + one.couplings.size();
    double sum = 0.0;
    for (const Coupling& c : one.couplings) sum += *kept++ * x[c.variable];
    x[one.variable] -= sum / d;
  }
}

}  // namespace tandem::mbs
