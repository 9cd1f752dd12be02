// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/driven.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace tandem {

Driven::Driven(const TimeSeries& series, std::size_t slot, TimeTolerance tolerance, double t_start)
    : slot_(slot), degree_(series.degree()), tolerance_(tolerance) {
  for (Segment piece : series.pieces()) {
    if (std::isfinite(piece.end)) piece.end += tolerance.width(piece.end, piece.end);
    if (!tolerance.before(t_start, piece.origin)) pieces_.clear(), mark_jump(piece, false);
    pieces_.push_back(piece);
  }
}

Driven::Driven(double value, std::size_t slot, TimeTolerance tolerance, bool at_instants)
    : pieces_{{std::numeric_limits<double>::infinity(), 0.0, {value}}},
      slot_(slot),
      degree_(0),
      tolerance_(tolerance),
      open_(true),
      at_instants_(at_instants) {}

/// What is past for its reader goes, and what was guessed from t on. What was before t ends just before it, so
/// that who stands there reads what begins. A jump has a piece of its own, of no length.
void Driven::go_on(double t, const Signal& u) {
  pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(std::exchange(first_, 0)));
  while (pieces_.size() > 1 && pieces_[pieces_.size() - 2].end >= t) pieces_.pop_back();
  const Signal from = u.from_jump_at(t);
  if (Segment& newest = pieces_.back(); tandem_segment_jumps(&newest) && newest.origin == t) {
    newest.c[0] = from.value(t);
  } else {
    const bool jumps = jumps_to(t, from);
    newest.end = std::nextafter(t, -std::numeric_limits<double>::infinity());
    if (jumps) mark_jump(pieces_.emplace_back(Segment{t, t, {from.value(t)}}), true);
  }
  if (at_instants_) pieces_.clear();  // none of its instants is before t
  append(t, from);
}

bool Driven::jumps_to(double t, const Signal& u) const {
  constexpr double rounding = 1e-9;
  const Segment& first = u.segments().front();
  const bool says_so = tandem_segment_jumps(&first) && first.origin == t;
  const double before = Signal(&pieces_.back(), 1, degree_).value(t), now = u.value(t);
  return (says_so || u.degree() == 0) &&
         std::abs(now - before) > rounding * std::max(std::abs(before), std::abs(now));
}

void Driven::append(double t, const Signal& u) {
  for (const Segment& s : u.segments()) {
    if (s.end <= t && &s != &u.segments().back()) continue;
    pieces_.push_back(s);
    if (s.origin == t && u.degree() < TANDEM_MAX_COEFFICIENTS - 1) mark_jump(pieces_.back(), false);
  }
  pieces_.back().end = std::numeric_limits<double>::infinity();
  degree_ = std::max(degree_, u.degree());
}

void Driven::forget_jump() {
  for (Segment& piece : pieces_)
    if (tandem_segment_jumps(&piece)) mark_jump(piece, false);
}

void Driven::write(ByteWriter& to) const {
  to.put(std::int32_t{degree_});
  to.put(static_cast<std::uint32_t>(pieces_.size()));
  for (const Segment& piece : pieces_) {
    to.put(piece.end), to.put(piece.origin);
    to.put_doubles(piece.c);
  }
}

void Driven::read(ByteReader& from) {
  constexpr std::size_t size_of_piece = (2 + TANDEM_MAX_COEFFICIENTS) * sizeof(double);
  first_ = 0;
  degree_ = from.take<std::int32_t>();
  pieces_.assign(from.take_count(size_of_piece), {});
  double before = -std::numeric_limits<double>::infinity();
  for (Segment& piece : pieces_) {
    piece.end = from.take<double>(), piece.origin = from.take<double>();
    from.take_doubles(piece.c);
    const bool finite = std::isfinite(piece.origin) && std::all_of(std::begin(piece.c), std::end(piece.c),
                                                                   [](double c) { return std::isfinite(c); });
    if (!finite || !(piece.end >= before)) from.refuse("has a piece of an open input that is none");
    before = piece.end;
  }
  if (degree_ < 0 || degree_ >= TANDEM_MAX_COEFFICIENTS || before != std::numeric_limits<double>::infinity())
    from.refuse("has an open input that is not known to the end");
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
