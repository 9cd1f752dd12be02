// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "four_bar/linkage.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::four_bar {
namespace {

using mbs::Mechanism;
using mbs::State;

/// The moving points are the first of the variables.
double tilt_of(const State& s, int loops) {
  double largest = 0.0;
  for (int i = 0; i < loops; ++i) largest = std::max(largest, std::abs(s.q[2 * i + 3] - s.q[2 * i + 1]));
  return largest;
}

/// Figures of the last state that is of use.
void tell(Mechanism& m, const State& s, int loops, Result& result) {
  const State start = m.described_state();
  const auto energy = [&](const State& at) { return m.energy(at.q.data(), at.v.data()); };
  const mbs::Residuals residuals = mbs::residuals(m, s);
  result.time = s.time;
  result.x_error = std::abs(s.q[0] - std::sin(exact(loops, s.time).angle));
  result.energy_drift = std::abs(energy(s) - energy(start)) / m.potential(start.q.data());
  result.position_residual = residuals.position;
  result.velocity_residual = residuals.velocity;
  result.acceleration_residual = residuals.acceleration;
}

}  // namespace

Result run(const Case& c, double end, const std::function<void(const Place&)>& seen) {
  Mechanism m(mbs::read_mechanism("four_bar", text(c.loops)));
  const auto stepper = mbs::make_stepper(m, c.stepper);
  State s = m.described_state();
  State last = s;
  Result result;
  long iterations = 0, k = 0;
  try {
    stepper->start(s);
    for (const long steps = std::lround(end / c.step); k < steps && result.status.empty(); ++k) {
      last = s;
      iterations += stepper->step(s, c.step, static_cast<double>(k + 1) * c.step);
      const Place place{s.time, tilt_of(s, c.loops), std::atan2(s.q[0], s.q[1])};
      if (seen) seen(place);
      result.largest_tilt = std::max(result.largest_tilt, place.tilt);
      if (!(place.tilt <= lost_tilt)) result.status = fmt::format("lost at {:.2f} s", s.time);
    }
    last = s;
    if (result.status.empty()) result.status = "ok";
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    result.status = fmt::format("failed at {:.2f} s", last.time);
    result.note = error.what();
    std::replace(result.note.begin(), result.note.end(), ',', ';');
  }
  if (k > 0) result.iterations = static_cast<double>(iterations) / static_cast<double>(k);
  tell(m, last, c.loops, result);
  return result;
}

}  // namespace tandem::four_bar
