// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/unmerged.hpp"

#include <utility>

#include "check_memory.hpp"
#include "flush_denormals.hpp"
#include "settings.hpp"

namespace tandem::mbs {

Unmerged::Unmerged(std::unique_ptr<Formulation> formulation, std::unique_ptr<Integrator> integrator)
    : formulation_(std::move(formulation)), integrator_(std::move(integrator)) {}

void Unmerged::start(State& s) {
  const FlushDenormals scope;
  formulation_->start(s);
  formulation_->begin(s, motion_);
  integrator_->start(*formulation_, motion_);
}

int Unmerged::step(State& s, double h, double t_end) {
  const FlushDenormals scope;
  Setting{"stepper", "the step", h}.positive();
  if (formulation_->begin(s, motion_)) integrator_->start(*formulation_, motion_);
  const int iterations = integrator_->step(*formulation_, motion_, h, t_end);
  formulation_->finish(motion_, s);
  return iterations;
}

void Unmerged::refresh(State& s) {
  const FlushDenormals scope;
  formulation_->refresh(s);
}

TangentFactors Unmerged::tangent_factors(double) const { return {0.0, 0.0, formulation_->penalty()}; }

/// The formulation's, the integrator's, and how many numbers are the first's.
void Unmerged::remember(std::vector<double>& to) const {
  const std::size_t begin = to.size();
  formulation_->remember(to);
  const auto first = static_cast<double>(to.size() - begin);
  integrator_->remember(to);
  to.push_back(first);
}

void Unmerged::recall(std::span<const double> memory) {
  check_memory(!memory.empty() && memory.back() >= 0.0 &&
               memory.back() <= static_cast<double>(memory.size() - 1));
  const auto first = static_cast<std::size_t>(memory.back());
  formulation_->recall(memory.first(first));
  integrator_->recall(memory.subspan(first, memory.size() - 1 - first));
}

}  // namespace tandem::mbs
