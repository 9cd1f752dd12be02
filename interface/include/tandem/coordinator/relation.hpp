// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "tandem/coordinator/member.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// Of two members which waits for the other: a pure function of their clocks.
struct Relation {
  enum class Kind : std::uint8_t {
    turns,    ///< `first` leads `second`: always one of them waits.
    held,     ///< `first` reads held outputs of the sampled `second`: it waits where these are not known yet.
    nearest,  ///< The sampled `first` reads `second`: it waits while that can come nearer to its instant.
    passed,   ///< The same where `second` does not depend on `first`: it waits until that has come there.
    after,    ///< The sampled `first` reads the sampled `second`: at equal instants too that acts before.
    together,  ///< The same among sampled ones that read each other: at equal instants they act together.
  };
  enum class Waits : std::uint8_t { none, first, second };

  int first, second;
  Kind kind;
  double lag;  ///< Time [s]: the reader sees at t what the source gave at t - lag.
  bool lands;  ///< Held, nearest: who integrates itself ends a step at each instant of the sampled one;
               ///< turns: `second` does so at each event of `first`.
  double period = 0.0;  ///< Nearest: the least time between two instants of the sampled one [s].
  bool reads = false;   ///< Turns: `first` reads `second`.

  bool operator==(const Relation&) const = default;

  Waits waits(const Member& a, const Member& b, const TimeTolerance& tolerance) const {
    if (kind == Kind::turns) return tolerance.before(a.time, b.next) ? Waits::second : Waits::first;
    if (first_waits(a, b, tolerance)) return Waits::first;
    return ends_steps() && !tolerance.before(b.time, a.next - lag) && tolerance.before(known(a), b.next)
               ? Waits::second
               : Waits::none;
  }
  /// `second` ends a step where the sampled `first` reads it.
  bool ends_steps() const { return lands && kind == Kind::nearest; }
  /// From where that is on it may do so again: no further is it known where it ends steps. That is not before
  /// the instant of `first`, as the lag is at most the period, so that nobody waits in a ring.
  double known(const Member& sampled) const { return sampled.next + (period - lag); }

 private:
  bool first_waits(const Member& a, const Member& b, const TimeTolerance& tolerance) const {
    switch (kind) {
      case Kind::held: {
        const double known = b.next + lag;
        return !tolerance.before(a.time, known) || tolerance.before(known, a.next);
      }
      case Kind::nearest:
        return !tolerance.before(a.next - lag, b.next);
      case Kind::passed:
        return tolerance.before(b.time, a.next - lag);
      case Kind::after:
        return !tolerance.before(a.next, b.next + lag);
      default:
        return tolerance.before(b.next + lag, a.next);
    }
  }
};

/// Those of a run. order: by number of member who integrates itself, leaders first, then the sampled ones.
/// reads: in any number and order. Each once, by kind, then by the places of its members. turns: whether they
/// go in turns.
std::vector<Relation> relations(std::span<const int> order, std::span<const Read> reads,
                                std::span<const Member> members, bool turns);

}  // namespace tandem
