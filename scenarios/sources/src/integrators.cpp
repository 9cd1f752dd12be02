// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/integrators.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tandem/engine/make_integrator.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem {
namespace {

long most_steps(Parameters& p, long otherwise) {
  const double value = p.number("most_steps", static_cast<double>(otherwise));
  if (value == std::floor(value) && value >= 1.0 && value <= 1e9) return static_cast<long>(value);
  throw Error(
      ErrorCode::invalid_argument,
      fmt::format("parameter 'most_steps' is {}; allowed is a whole number from 1 to 1000000000", value));
}

}  // namespace

Words integrator_words() {
  return words_by(Setter::client, {"integrator", "relative_tolerance", "absolute_tolerance",
                                   "absolute_tolerance.*", "longest_step", "shortest_step", "most_steps"});
}

void take_adaptive(Parameters& p, engine::AdaptiveSettings& s) {
  s.relative_tolerance = p.number("relative_tolerance", s.relative_tolerance);
  s.absolute_tolerance = p.number("absolute_tolerance", s.absolute_tolerance);
  s.absolute_tolerances = p.numbers("absolute_tolerance.");
  s.longest_step = p.number("longest_step", s.longest_step);
  s.shortest_step = p.number("shortest_step", s.shortest_step);
  s.most_steps = most_steps(p, s.most_steps);
}

std::unique_ptr<AdaptiveIntegrator> take_integrator(Parameters& p) {
  const std::string name = p.text("integrator", "rk4");
  if (name == "rk4") return nullptr;
  engine::AdaptiveSettings settings;
  take_adaptive(p, settings);
  if (auto integrator = engine::adaptive_integrator(name, settings)) return integrator;
  throw Error(ErrorCode::invalid_argument,
              unknown("parameter 'integrator': integrator", name, engine::integrator_names()));
}

}  // namespace tandem
