// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/impulse_source.hpp"

#include "tandem/coordinator/impulse/impulse_surrogate.hpp"

namespace tandem::scenario {
namespace {

std::unique_ptr<Subsystem> make(const Address&, Parameters& p) {
  ImpulseCoupling c;
  c.own_step = p.number("own_step", 0.0), c.slow_step = p.number("slow_step", 0.0);
  c.fast_period = p.number("fast_period", 0.0);
  const std::size_t links = p.numbers("velocity.").size();
  for (std::size_t k = 1; k <= links; ++k) {
    const std::string at = "." + std::to_string(k);
    c.links.push_back({p.text("force_unit" + at, ""), p.text("displacement_unit" + at, ""),
                       p.number("velocity" + at, 0.0), p.number("free_acceleration" + at, 0.0),
                       p.text("velocity_unit" + at, "")});
  }
  for (std::size_t k = 1; k <= links * links; ++k)
    c.accelerance.push_back(p.number("accelerance." + std::to_string(k), 0.0));
  const std::size_t rates = p.numbers("accelerance_rate.").size();
  for (std::size_t k = 1; k <= rates; ++k) {
    const std::string at = "." + std::to_string(k);
    c.accelerance_rate.push_back(p.number("accelerance_rate" + at, 0.0));
    c.accelerance_units.push_back(p.text("accelerance_unit" + at, ""));
  }
  for (const auto& [at, value] : p.numbers("stiffness."))
    c.stiffness.push_back(value), c.damping.push_back(p.number("damping." + at, 0.0));
  c.trapezoidal = p.flag("trapezoidal", false);
  c.tells_velocities = p.flag("tells_velocities", false);
  c.found = p.number("found", 0.0);
  c.degree = static_cast<int>(p.number("degree", 3.0));
  return impulse_surrogate(std::move(c));
}

}  // namespace

void add_impulse(Builtins& builtins) {
  builtins.models["impulse_surrogate"] = {
      words_by(
          Setter::operator_only,
          {"own_step", "slow_step", "fast_period", "force_unit.*", "displacement_unit.*", "velocity_unit.*",
           "velocity.*", "free_acceleration.*", "accelerance.*", "accelerance_rate.*", "accelerance_unit.*",
           "stiffness.*", "damping.*", "trapezoidal", "degree", "tells_velocities", "found"}),
      make};
}

}  // namespace tandem::scenario
