// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mean and matched hold: one value for a step of the reader.
#include <algorithm>

#include "tandem/coordinator/link.hpp"

namespace tandem {

void Link::read_window(double time, double next_time, Signal* slots) {
  const Rows rows = window(time, next_time);
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const Lane& lane = lanes_[l];
    segments_[l].end = next_time;
    segments_[l].origin = samples_->time(rows.last);
    segments_[l].c[0] = lane.gain * mean(lane, rows, {time, next_time}) + lane.offset;
    slots[lane.slot] = Signal(&segments_[l], 1, 0);
  }
}

void Link::sample_window(TimeSpan to, double* u) {
  read_from_ = to.start;
  const Rows rows = window(to.start, to.stop);
  for (const Lane& lane : lanes_) u[lane.slot] = lane.gain * mean(lane, rows, to) + lane.offset;
}

/// Mean: the rows in [time, next_time], else the newest before them. Matched hold: the newest row.
Link::Rows Link::window(double time, double next_time) const {
  std::int64_t first = samples_->newest(), last = first;
  if (how_.kind == Reconstruction::Kind::mean) {
    while (last > samples_->oldest() && tolerance_.before(next_time, samples_->time(last))) --last;
    first = last;
    while (first > samples_->oldest() && !tolerance_.before(samples_->time(first - 1), time)) --first;
  }
  return {first, last};
}

double Link::mean(const Lane& lane, Rows rows, TimeSpan span) const {
  if (lane.held && tolerance_.before(span.start, span.stop)) return held_mean(lane, rows, span);
  if (rows.last < samples_->newest() && tolerance_.before(samples_->time(rows.last), span.start))
    return line_mean(lane, rows.last, span);
  double sum = 0.0;
  for (std::int64_t row = rows.first; row <= rows.last; ++row) sum += value(row, lane);
  return sum / static_cast<double>(rows.last - rows.first + 1);
}

/// Of the line through this row and the next, which lie on either side of the span.
double Link::line_mean(const Lane& lane, std::int64_t row, TimeSpan span) const {
  const double t = samples_->time(row), h = samples_->time(row + 1) - t;
  const double y = value(row, lane), middle = (span.start + span.stop) / 2.0;
  return y + (value(row + 1, lane) - y) * ((middle - t) / h);
}

/// By time: each sample holds to the next one, and the one before the first of the rows to that.
double Link::held_mean(const Lane& lane, Rows rows, TimeSpan span) const {
  double sum = 0.0, from = span.start;
  std::int64_t row = rows.first > samples_->oldest() ? rows.first - 1 : rows.first;
  for (; row <= rows.last; ++row) {
    const double to = row < rows.last ? std::clamp(samples_->time(row + 1), from, span.stop) : span.stop;
    sum += (to - from) * value(row, lane);
    from = to;
  }
  return sum / (span.stop - span.start);
}

}  // namespace tandem
