// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/mbs/formulations/formulation.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::mbs {

/// Any formulation with any integrator.
class Unmerged final : public Stepper {
 public:
  Unmerged(std::unique_ptr<Formulation> formulation, std::unique_ptr<Integrator> integrator);

  void start(State& state) override;
  int step(State& state, double h, double t_end) override;
  void refresh(State& state) override;
  TangentFactors tangent_factors(double h) const override;
  void remember(std::vector<double>& to) const override;
  void recall(std::span<const double> memory) override;

 private:
  std::unique_ptr<Formulation> formulation_;
  std::unique_ptr<Integrator> integrator_;
  Motion motion_;
};

}  // namespace tandem::mbs
