// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/subsystem.hpp"

#include "sampled_diagram.hpp"

namespace tandem::engine {
namespace {

/// Null for a subsystem that make_subsystem() has not made.
const DiagramModel* model_of(const Subsystem& subsystem) {
  if (const auto* steps = dynamic_cast<const FixedStep<DiagramModel>*>(&subsystem)) return &steps->model();
  const auto* sampled = dynamic_cast<const SampledDiagram*>(&subsystem);
  return sampled ? &sampled->model() : nullptr;
}

}  // namespace

std::unique_ptr<Subsystem> make_subsystem(const Description& diagram, const SubsystemSettings& settings) {
  DiagramModel model(diagram, settings);
  if (model.program().sampled()) return std::make_unique<SampledDiagram>(model);
  return std::make_unique<FixedStep<DiagramModel>>(std::move(model));
}

std::optional<Statistics> statistics_of(const Subsystem& subsystem) {
  const DiagramModel* model = model_of(subsystem);
  return model ? std::optional(model->statistics()) : std::nullopt;
}

}  // namespace tandem::engine
