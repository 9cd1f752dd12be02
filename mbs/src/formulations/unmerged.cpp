// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/unmerged.hpp"

#include <utility>

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

}  // namespace tandem::mbs
