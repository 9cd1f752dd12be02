// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sampled_diagram.hpp"

#include "tandem/error.hpp"

namespace tandem::engine {

SampledDiagram::SampledDiagram(const DiagramModel& model) : SavedModels(model) {
  info_.abilities.sampled = true;
  info_.sampling.period = model_.program().shortest_period;
}

Clock SampledDiagram::initialize(double t_start, double /*t_stop*/, std::span<const double> u0, Samples& y) {
  model_.start(t_start, u0);
  place_ = {t_start, model_.next_instant()};
  model_.outputs(y.append(t_start));
  return place_.clock();
}

Clock SampledDiagram::advance(double, bool, std::span<const Signal>, Samples&) {
  throw Error(ErrorCode::not_supported, "subsystem '" + info_.name + "' is sampled and takes no own steps");
}

/// An instant of a diagram is one thing: what its outputs are is known when all has happened.
Clock SampledDiagram::sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) {
  if (part == SamplePart::outputs) {
    model_.look(t, u, y.data());
    return place_.clock();
  }
  model_.act(t, u);
  if (part == SamplePart::both) model_.outputs(y.data());
  place_ = {t, model_.next_instant()};
  return place_.clock();
}

}  // namespace tandem::engine
