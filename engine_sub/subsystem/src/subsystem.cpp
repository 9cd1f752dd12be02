// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/subsystem.hpp"

#include <fmt/format.h>

#include "diagram_model.hpp"

namespace tandem::engine {

std::unique_ptr<Subsystem> make_subsystem(const Description& diagram, const SubsystemSettings& settings) {
  return std::make_unique<FixedStep<DiagramModel>>(DiagramModel(diagram, settings));
}

std::optional<Statistics> statistics_of(const Subsystem& subsystem) {
  const auto* diagram = dynamic_cast<const FixedStep<DiagramModel>*>(&subsystem);
  return diagram ? std::optional(diagram->model().statistics()) : std::nullopt;
}

std::vector<std::string> data_ending_before(const Subsystem& subsystem, double t) {
  const auto* diagram = dynamic_cast<const FixedStep<DiagramModel>*>(&subsystem);
  std::vector<std::string> all;
  if (!diagram) return all;
  const Program& program = diagram->model().program();
  for (const Range& r : program.ranges)
    if (r.signal == program.time && TimeTolerance().before(r.high, t))
      all.push_back(fmt::format("{}: the data end at t = {} s", r.owner, r.high));
  return all;
}

}  // namespace tandem::engine
