// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string>
#include <utility>

#include "tandem/fixed_step.hpp"

namespace tandem::test {

/// Gives sin t with two derivatives and hears its input at three times a step, but does not heed it: a
/// partner that keeps a run bounded whatever the scheme. For FixedStep<Model>.
class Wave {
 public:
  explicit Wave(double own_step, std::string unit = "1") : unit_(std::move(unit)), own_step_(own_step) {}
  SubsystemInfo info() const { return {"wave", {{"u", unit_}}, {{"y", unit_, 1, 2}}, {}, {}}; }
  double own_step() const { return own_step_; }
  void start(double t, std::span<const double>) { time_ = t; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    heard_ += u[0].value(s.begin) + u[0].value(s.begin + 0.5 * s.length) + u[0].value(s.end);
    time_ = s.end;
  }
  void outputs(double* y) const {
    y[0] = std::sin(time_);
    y[1] = std::cos(time_);
    y[2] = -y[0];
  }
  double heard() const { return heard_; }

 private:
  std::string unit_;
  double own_step_, time_ = 0.0, heard_ = 0.0;
};

}  // namespace tandem::test
