// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace tandem {

/// What a schedule sees of a subsystem.
struct alignas(32) Member {
  static constexpr double never = std::numeric_limits<double>::max();

  double time = never;  ///< Where it stands [s]; `never` if it takes no further part.
  /// Where its next own step ends [s], at most where it is to land; of a sampled one its next instant;
  /// `never` likewise.
  double next = never;
  bool lands = false;     ///< Can cut a step.
  bool one_step = false;  ///< A turn is one own step, as an input is a mean over it, or as it may go back.
  bool sampled = false;   ///< Acts at instants of its own only.
  bool events = false;    ///< Stops where its outputs jump.
  bool jumps = false;     ///< Outputs jump with inputs, and are told in a second row where it stands.
  bool jumped = false;  ///< Inputs have jumped where it stands, and it has not told yet whether outputs have.
  double landing = never;  ///< It ends a step there [s], if it gets so far.

  bool finished() const { return next == never; }
};

/// `reader` has an input from `source`.
struct Read {
  int reader, source;
  double lag = 0.0;          ///< Time [s]: the reader sees at t what the source gave at t - lag.
  bool just_before = false;  ///< Between sampled ones: the value just before an instant.
  /// The one that integrates itself ends a step at each instant of the sampled one; the reader of one with
  /// events at each of these.
  bool lands = false;
  double period = 0.0;  ///< Of a sampled reader, the least time between two instants [s]; at least the lag
                        ///< where the source lands.
};

}  // namespace tandem
