// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/subsystem.hpp"

#include "diagram_model.hpp"

namespace tandem::engine {

std::unique_ptr<Subsystem> make_subsystem(const Description& diagram, const SubsystemSettings& settings) {
  return std::make_unique<FixedStep<DiagramModel>>(DiagramModel(diagram, settings));
}

std::optional<Statistics> statistics_of(const Subsystem& subsystem) {
  const auto* diagram = dynamic_cast<const FixedStep<DiagramModel>*>(&subsystem);
  return diagram ? std::optional(diagram->model().statistics()) : std::nullopt;
}

}  // namespace tandem::engine
