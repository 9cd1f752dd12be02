// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "diagram_model.hpp"
#include "tandem/saved_models.hpp"

namespace tandem::engine {

/// Where a sampled diagram stands.
struct InstantPlace {
  double time = 0.0, next = 0.0;  ///< [s]

  Clock clock() const { return {time, next, Stop::limit}; }
  void write(ByteWriter& to) const { to.put(time), to.put(next); }
  void read(ByteReader& from) { time = from.take<double>(), next = from.take<double>(); }
};

/// A diagram whose outputs change at its own instants alone.
class SampledDiagram final : public SavedModels<DiagramModel, InstantPlace> {
 public:
  explicit SampledDiagram(const DiagramModel& model);

  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;
  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override;
};

}  // namespace tandem::engine
