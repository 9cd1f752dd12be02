// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "known_steps.hpp"

#include <fmt/format.h>

#include "tandem/scenario/steps.hpp"

namespace tandem::study {

std::string known_steps(const scenario::Scenario& scenario, const Builtins& builtins, double factor) {
  scenario::Scenario scaled = scenario;
  scenario::scale_known_steps(scaled, builtins, factor);
  std::string lines;
  if (const auto& step = scaled.coordination.communication_step)
    lines += fmt::format("\"coordination.communication_step\" = {:.17g}\n", *step);
  for (const auto& [subsystem, parameter, value] : scenario::changed_steps(scenario, scaled))
    lines += fmt::format("\"subsystems.{}.parameters.{}\" = {:.17g}\n", subsystem, parameter, value);
  return lines;
}

}  // namespace tandem::study
