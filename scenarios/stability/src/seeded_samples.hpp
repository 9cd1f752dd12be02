// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "seeded.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::stability {

/// A sampled subsystem with a past of our own. Its states are those after an instant at `begin`.
class SeededSamples final : public Seeded {
 public:
  /// offset: from `begin` to the first instant of inner after initialize() there, at least 0 and below the period.
  /// inner takes set_states() at any time.
  SeededSamples(Subsystem& inner, double begin, double period, double offset)
      : Seeded(inner, begin, period), offset_(offset) {}

  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;
  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override;

 private:
  double instant(std::int64_t k) const { return (begin() + offset_) + static_cast<double>(k) * step(); }
  bool is_past(std::int64_t k) const { return !tolerance_.before(begin(), instant(k)); }
  std::vector<double> row_of(std::int64_t k) const;
  void enter(std::span<const double> u);

  double offset_, stop_ = 0.0, time_ = 0.0;
  TimeTolerance tolerance_;
  std::int64_t next_ = 0;  ///< number of the next instant
  bool entered_ = false;
  std::vector<double> now_;  ///< what it gives at this one
};

}  // namespace tandem::stability
