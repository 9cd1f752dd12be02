// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/trajectory.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tandem/error.hpp"

namespace tandem::mbs {

Trajectory trajectory(Model& model, State state, const StepperSettings& settings, double h, int steps) {
  if (!(h > 0.0) || !std::isfinite(h) || steps < 0)
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("{} steps of {} s; allowed are 0 or more steps of a finite time above 0", steps, h));
  Trajectory all{Eigen::VectorXd(steps + 1), Eigen::MatrixXd(steps + 1, state.q.size()),
                 Eigen::MatrixXd(steps + 1, state.q.size())};
  const auto keep = [&](int row) {
    all.time[row] = state.time;
    all.q.row(row) = state.q;
    all.v.row(row) = state.v;
  };
  const auto stepper = make_stepper(model, settings);
  const double begin = state.time;
  stepper->start(state);
  keep(0);
  for (int k = 1; k <= steps; ++k) {
    all.iterations += stepper->step(state, h, begin + k * h);
    keep(k);
  }
  return all;
}

}  // namespace tandem::mbs
