// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "tandem/engine/simulation.hpp"
#include "tandem/error.hpp"

// Events that put a state so that their signal turns back: the bounces of a ball. A short step after each
// says whether it does. It lets a bounce be seen that ends within the same own step, and tells when there is
// no next one: bounces come ever faster, and after the last of infinitely many of them the diagram says
// nothing. A signal that has not turned back the time before, as that of a threshold with a reset, goes where
// it will.
namespace tandem::engine {
namespace {

constexpr double known = -std::numeric_limits<double>::infinity();
constexpr double short_part = 1e-6;  // of an own step

}  // namespace

double Simulation::short_step() const {
  return std::max(short_part * system_.image()[system_.program().longest_step], 8.0 * rounding());
}

/// On the side to which its event sees it go.
bool Simulation::is_beyond(const Crossing& c) const {
  const double signal = system_.image()[c.signal];
  return c.direction == Crossing::Direction::falling ? signal < 0.0 : signal > 0.0;
}

/// When it has to be looked whether a signal turns back.
double Simulation::next_turn() const {
  double next = std::numeric_limits<double>::infinity();
  for (const Crossing& c : system_.program().crossings)
    if (c.turn >= 0 && system_.image()[c.turn] != known)
      next = std::min(next, system_.image()[c.turn] + short_step());
  return next;
}

/// At the end of a step. One that is looked at too late, by an integrator from elsewhere, says nothing.
void Simulation::look_at_turns() {
  for (const Crossing& c : system_.program().crossings) {
    if (c.turn < 0 || slot(c.turn) == known) continue;
    const bool beyond = is_beyond(c), late = time_ > slot(c.turn) + 2.0 * short_step();
    if (beyond && time_ < slot(c.turn) + short_step() - rounding()) continue;
    const double event = std::exchange(slot(c.turn), known);
    const bool turned = std::exchange(slot(c.turn + 1), beyond || late ? 0.0 : 1.0) != 0.0;
    if (turned && beyond && !late) refuse_endless(c, event);
  }
}

void Simulation::refuse_endless(const Crossing& c, double t) const {
  throw Error(
      ErrorCode::numerical,
      fmt::format("{}: what happens at t = {} s does not turn its signal back any more, as it did before; "
                  "it has come ever faster, and has no end; allowed is what gives it one, as a machine or "
                  "a switch at a smallest speed",
                  system_.program().named(c.name), t));
}

}  // namespace tandem::engine
