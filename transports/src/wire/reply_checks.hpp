// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::wire {

// What a reply must hold before it is believed. Each throws Error(numerical) for what it does not.

/// The rows of y from `first` on, and the clock that came with them.
struct GivenRows {
  const SubsystemInfo& info;
  const Samples& y;
  std::int64_t first;
  Clock clock;
};

/// Of initialize: samples of t_start, of which the newest is finite but for outputs with feedthrough of an
/// input that is NaN in u0, and for derivatives where any is; the clock stands there.
void check_first(const GivenRows& given, double t_start, std::span<const double> u0);

/// Where an advance began, and up to where it was asked for [s].
struct AskedSpan {
  double from, limit;
};

/// Of an advance: all is finite, jump flags are 0 or 1, each row is later than the one before it (or as late,
/// at a jump), none is past the limit, and the clock stands at the last one.
void check_rows(const GivenRows& given, const AskedSpan& asked, const TimeTolerance& tolerance);

/// A clock wherever it stands: a finite time, and a later one for the next own step unless there is none.
/// A sampled subsystem may have its first instant where it stands.
void check_clock(const SubsystemInfo& info, const Clock& clock);

/// Of a sample at t: outputs that are finite.
void check_sample(const SubsystemInfo& info, std::span<const double> y, double t);
/// Of its states: it stands at t, and its next instant is later.
void check_next_instant(const Clock& clock, double t);

}  // namespace tandem::wire
