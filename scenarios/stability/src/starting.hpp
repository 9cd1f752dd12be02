// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem::stability {

/// A subsystem at the start of a run, which tells the inputs that it starts with.
class Starting final : public Subsystem {
 public:
  explicit Starting(Subsystem& inner)
      : inner_(inner), inputs_(static_cast<std::size_t>(info().input_size())) {}

  /// The last ones that were known; 0 for one that never was.
  const std::vector<double>& inputs() const { return inputs_; }

  const SubsystemInfo& info() const override { return inner_.info(); }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      if (!std::isnan(u0[i])) inputs_[i] = u0[i];
    return inner_.initialize(t_start, t_stop, u0, y);
  }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    return inner_.advance(t_limit, land, u, y);
  }
  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override {
    return inner_.sample(t, part, u, y);
  }

 private:
  Subsystem& inner_;
  std::vector<double> inputs_;
};

}  // namespace tandem::stability
