// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/independent.hpp"

#include <algorithm>
#include <utility>

#include "../dense.hpp"
#include "linear_forces.hpp"
#include "scaled.hpp"
#include "tandem/mbs/mechanism/initial.hpp"

namespace tandem::mbs {
namespace {

std::vector<int> independent(Model& of, State at) {
  Scaled model(of);
  model.at_time(at.time);
  model.scale(at);
  DenseTerms terms(model);
  terms.evaluate(at.q, at.v);
  const dense::MatrixXd free = free_motions(terms.gradients);
  const dense::Qr qr(free.transpose());
  const auto& order = qr.colsPermutation().indices();
  std::vector<int> all(order.begin(), order.begin() + free.cols());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

Independent::Independent(Model& model, const State& at) : model_(model), rates_(independent(model, at)) {
  const Structure& s = model.structure();
  const auto is_state = [&](int k) {
    return std::find(s.states.begin(), s.states.end(), k) != s.states.end();
  };
  const auto name = [&](int k) { return s.variable_names[static_cast<std::size_t>(k)]; };
  std::copy_if(rates_.begin(), rates_.end(), std::back_inserter(positions_),
               [&](int k) { return !is_state(k); });
  for (const int k : positions_) names_.push_back(name(k));
  for (const int k : rates_) names_.push_back(is_state(k) ? name(k) : name(k) + "_rate");
}

void Independent::get(const State& from, std::span<double> x) const {
  auto to = x.begin();
  for (const int k : positions_) *to++ = from.q[k];
  for (const int k : rates_) *to++ = from.v[k];
}

State Independent::put(State near, std::span<const double> x) const {
  Known known;
  auto from = x.begin();
  for (const int k : positions_) known.positions.push_back({k, *from++});
  for (const int k : rates_) known.velocities.push_back({k, *from++});
  return consistent_state(model_, std::move(near), known);
}

}  // namespace tandem::mbs
