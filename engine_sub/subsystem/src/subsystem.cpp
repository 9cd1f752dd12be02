// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/subsystem.hpp"

#include "sampled_diagram.hpp"

namespace tandem::engine {
std::unique_ptr<Subsystem> make_subsystem(const Description& diagram, const SubsystemSettings& settings) {
  DiagramModel model(diagram, settings);
  if (model.program().sampled()) return std::make_unique<SampledDiagram>(model);
  return std::make_unique<FixedStep<DiagramModel>>(std::move(model));
}

}  // namespace tandem::engine
