// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tandem/engine/simulation.hpp"
#include "tandem/error.hpp"

// What a run refuses to go on with, or tells.
namespace tandem::engine {
namespace {

/// 0 for a finite number and nothing else: x - x is +0 then, else not a number. Without a branch, so that
/// many are looked at side by side.
std::uint64_t not_finite(double x) { return std::bit_cast<std::uint64_t>(x - x); }

}  // namespace

/// A signal may be beyond its limits from the start on, which the inputs of the first step tell.
void Simulation::look_at_bounds() {
  if (was_told_.empty()) return;
  system_.evaluate_again(time_);
  for (const Crossing& c : system_.program().crossings)
    if (c.bound >= 0 && system_.image()[c.signal] > 0.0) leave(c);
}

void Simulation::leave(const Crossing& crossing) {
  const Bound& bound = system_.program().bounds[static_cast<std::size_t>(crossing.bound)];
  const auto text = fmt::format("{} from t = {} s on: {}", bound.what, time_, bound.sentence);
  if (bound.stops) throw Error(ErrorCode::numerical, text);
  if (was_told_[static_cast<std::size_t>(crossing.bound)]) return;
  was_told_[static_cast<std::size_t>(crossing.bound)] = true;
  if (settings_.tell) settings_.tell(text);
}

void Simulation::arrive(double t) {
  time_ = t;
  refuse_not_finite();
  if (!system_.program().ranges.empty()) refuse_outside();
}

/// States and outputs are numbers; a signal whose sign decides may be infinite.
bool Simulation::is_finite() const {
  const Program& program = system_.program();
  const auto& image = system_.image();
  std::uint64_t bits = 0;
  for (int i = 0; i < program.states; ++i) bits |= not_finite(image[i]);
  for (const int slot : program.outputs) bits |= not_finite(image[slot]);
  return bits == 0 && std::none_of(program.crossings.begin(), program.crossings.end(),
                                   [&](const Crossing& c) { return std::isnan(image[c.signal]); });
}

/// The first block that makes what is not finite out of what is; else the first state that is not.
void Simulation::refuse_not_finite() const {
  if (is_finite()) return;
  if (const std::string source = system_.not_finite(); !source.empty())
    throw Error(ErrorCode::numerical, fmt::format("{} at t = {} s", source, time_));
  const Program& program = system_.program();
  for (int i = 0; i < program.states; ++i)
    if (const double value = system_.image()[i]; !std::isfinite(value))
      throw Error(ErrorCode::numerical, fmt::format("the state of {} is {} at t = {} s",
                                                    program.named(program.signal_blocks[i]), value, time_));
}

void Simulation::refuse_outside() const {
  for (const Range& r : system_.program().ranges) {
    const double value = system_.image()[r.signal];
    const double rounding =
        4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(r.low), std::abs(r.high));
    if (value >= r.low - rounding && value <= r.high + rounding) continue;
    throw Error(
        ErrorCode::numerical,
        fmt::format("{}: {} is {} at t = {} s; allowed is {} to {}, or another word at its key beyond",
                    r.owner, r.what, value, time_, r.low, r.high));
  }
}

}  // namespace tandem::engine
