// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "true_modes.hpp"

#include <utility>

#include "sampled_map.hpp"
#include "undivided.hpp"

namespace tandem::stability {
namespace {

using Eigen::Index;

TrueModes of_rates(const Undivided& whole) {
  auto [rates, vectors, parts] = participation(whole);
  return {std::move(rates), std::move(vectors), std::move(parts), whole.names};
}

void count_at_rest(double period, TrueModes& modes) {
  for (Index k = 0; k < modes.rates.size(); ++k)
    modes.at_rest += std::abs(modes.rates[k]) * period <= TrueModes::rest;
}

}  // namespace

TrueModes true_modes(const Trial& trial, bool is_linear) {
  bool samples = false;
  for (int i = 0; i < trial.topology().size(); ++i)
    samples = samples || trial.topology().info(i).abilities.sampled;
  TrueModes modes = samples ? SampledMap(trial, is_linear).modes() : of_rates(undivided(trial, is_linear));
  count_at_rest(trial.period().length, modes);
  return modes;
}

}  // namespace tandem::stability
