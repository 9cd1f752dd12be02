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
  for (std::size_t k = 0; k < scaled.subsystems.size(); ++k)
    for (const scenario::Parameter& now : scaled.subsystems[k].parameters) {
      const double* number = std::get_if<double>(&now.value);
      const auto& before = scenario.subsystems[k].parameters;
      const bool is_new = std::ranges::none_of(
          before, [&](const auto& one) { return one.name == now.name && one.value == now.value; });
      if (number && is_new)
        lines += fmt::format("\"subsystems.{}.parameters.{}\" = {:.17g}\n", scaled.subsystems[k].name,
                             now.name, *number);
    }
  return lines;
}

}  // namespace tandem::study
