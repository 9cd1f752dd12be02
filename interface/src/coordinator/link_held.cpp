// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Held outputs, and what sampled subsystems read.
#include <algorithm>
#include <limits>

#include "tandem/coordinator/link.hpp"

namespace tandem {

/// The last segment holds until it is known when the next one begins.
void Link::extend_held(Link& link, NewRows rows) {
  const double* row = rows.first;
  for (std::int64_t left = rows.count; left > 0; --left, row += link.stride_) {
    const double begin = row[0] + link.delay_, end = begin + link.tolerance_.width(begin, begin);
    Segment* s = link.first_ + link.count_++;
    for (const Lane& lane : link.lanes_) {
      s->end = std::numeric_limits<double>::infinity();
      s->origin = begin;
      s->c[0] = lane.gain * row[Samples::header + lane.output] + lane.offset;
      mark_jump(*s, link.count_ > 1 && s[-1].c[0] != s->c[0]);
      if (link.count_ > 1) s[-1].end = end;
      s += link.capacity_;
    }
  }
}

void Link::read_otherwise(double time, double next_time, Signal* slots) {
  if (!follows_) return read_window(time, next_time, slots);
  held_ ? forget_held(time) : forget_to(time);
  const bool past = is_past_last(time);
  const Segment* s = first_ + (past ? 1 : 0);
  const std::int32_t count = past ? 1 : count_ + (goes_on_ ? 1 : 0);
  for (const Lane& lane : lanes_) {
    slots[lane.slot] = Signal(s, count, degree_);
    s += capacity_;
  }
}

/// Of a source with events its rows tell, also those that readers do not see before a round is over, and
/// what is expected of it.
double Link::next_break(double time) const {
  if (has_events_) return next_jump(time);
  for (std::int32_t k = 1; k < count_; ++k)
    if (tolerance_.before(time, first_[k].origin)) return first_[k].origin;
  return Member::never;
}

double Link::next_jump(double time) const {
  double next = tolerance_.before(time, expected_) ? expected_ : Member::never;
  for (std::int64_t row = samples_->newest(); row > samples_->oldest(); --row) {
    const double t = samples_->time(row) + delay_;
    if (!tolerance_.before(time, t)) break;
    const auto jumps_there = [&](const Lane& lane) { return jumps(samples_->row(row), lane); };
    if (samples_->jump(row) && std::any_of(lanes_.begin(), lanes_.end(), jumps_there))
      next = std::min(next, t);
  }
  return next;
}

bool Link::jumps_at(double time) const {
  for (std::int32_t k = 1; k < count_; ++k) {
    const double at = first_[k].origin;
    if (!tolerance_.before(at, time) && !tolerance_.before(time, at) && jumps_in(first_ + k)) return true;
  }
  return false;
}

bool Link::jumps_in(const Segment* of_first) const {
  for (std::size_t l = 0; l < lanes_.size(); ++l, of_first += capacity_)
    if (tandem_segment_jumps(of_first)) return true;
  return false;
}

void Link::remake(const double* row) {
  if (!follows_) return;
  Segment* s = first_ + (count_ - 1);
  for (const Lane& lane : lanes_) {
    s->c[0] = lane.gain * row[Samples::header + lane.output] + lane.offset;
    if (held_ && count_ > 1) mark_jump(*s, s[-1].c[0] != s->c[0]);
    s += capacity_;
  }
}

/// Whether the first segment is not the one that a sampled reader wants at t, but a later one.
bool Link::is_past(double t) const {
  if (count_ == 1) return false;
  const double next = first_[1].origin;
  if (held_) return just_before_ ? tolerance_.before(next, t) : !tolerance_.before(t, next);
  if (within_) return !tolerance_.before(t, next) && tolerance_.before(first_->origin, t);
  return first_->end < t;
}

void Link::sample(TimeSpan to, double* u) {
  been_read_ = true;
  if (!follows_) return sample_window(to, u);
  for (; is_past(to.stop); --count_) ++first_;
  const Segment* s = first_ + (is_past_last(to.stop) ? 1 : 0);
  for (const Lane& lane : lanes_) {
    u[lane.slot] = Signal(s, 1, degree_).value(to.stop);
    s += capacity_;
  }
}

}  // namespace tandem
