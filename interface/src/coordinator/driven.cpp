// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/driven.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

Driven::Driven(const TimeSeries& series, std::size_t slot, TimeTolerance tolerance, double t_start)
    : slot_(slot), degree_(series.degree()), tolerance_(tolerance) {
  for (Segment piece : series.pieces()) {
    if (std::isfinite(piece.end)) piece.end += tolerance.width(piece.end, piece.end);
    if (!tolerance.before(t_start, piece.origin)) pieces_.clear(), mark_jump(piece, false);
    pieces_.push_back(piece);
  }
}

/// Whether one that stands at `time` reads a later piece than this one.
bool Driven::is_past(std::size_t k, double time) const {
  if (k + 1 == pieces_.size()) return false;
  const Segment& next = pieces_[k + 1];
  return pieces_[k].end < time || (tandem_segment_jumps(&next) && !tolerance_.before(time, next.origin));
}

Signal Driven::over(double time, double limit) {
  while (first_ > 0 && !is_past(first_ - 1, time)) --first_;  // the reader has gone back
  while (is_past(first_, time)) ++first_;
  std::size_t last = first_;
  while (last + 1 < pieces_.size() && pieces_[last].end < limit) ++last;
  return {&pieces_[first_], static_cast<std::int32_t>(last - first_ + 1), degree_};
}

bool Driven::jumps_at(double time) const {
  auto near = std::lower_bound(pieces_.begin(), pieces_.end(), time - tolerance_.width(time, time),
                               [](const Segment& s, double t) { return s.origin < t; });
  for (; near != pieces_.end() && !tolerance_.before(time, near->origin); ++near)
    if (tandem_segment_jumps(&*near)) return true;
  return false;
}

}  // namespace tandem
