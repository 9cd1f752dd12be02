// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/link.hpp"

#include <algorithm>
#include <utility>

namespace tandem {

Link::Link(int source, int reader, Reconstruction how, double delay)
    : source_(source),
      reader_(reader),
      how_(how),
      degree_(how.polynomial_degree()),
      follows_(how.follows_samples()),
      delay_(delay) {}

void Link::restart(const History& source, TimeTolerance tolerance) {
  tolerance_ = tolerance;
  capacity_ = follows_ ? source.capacity() : 1;
  base_ = end_ = cursor_ = fit_from_ = source.oldest();
  segments_.assign(lanes_.size() * static_cast<std::size_t>(capacity_), Segment{});
  differences_.assign(lanes_.size() * TANDEM_MAX_COEFFICIENTS, 0.0);
}

void Link::extend(const History& source) {
  switch (how_.kind) {
    case Reconstruction::Kind::lagrange:
      break;
    case Reconstruction::Kind::hermite:
      return extend_hermite(source);
    case Reconstruction::Kind::least_squares:
      return extend_least_squares(source);
    default:
      return;
  }
  switch (how_.degree) {
    case 0:
      return extend_lagrange<0>(source);
    case 1:
      return extend_lagrange<1>(source);
    case 2:
      return extend_lagrange<2>(source);
    case 3:
      return extend_lagrange<3>(source);
    default:
      return extend_lagrange<4>(source);
  }
}

/// Mean: the rows in [time, next_time], else the newest before. Matched hold: the newest row.
void Link::read_window(const History& source, double time, double next_time, Signal* slots) {
  std::int64_t first = source.newest(), last = first;
  if (how_.kind == Reconstruction::Kind::mean) {
    while (last > source.oldest() && tolerance_.before(next_time, source.time(last))) --last;
    first = last;
    while (first > source.oldest() && !tolerance_.before(source.time(first - 1), time)) --first;
  }
  hold(source, first, last, slots);
  for (std::size_t l = 0; l < lanes_.size(); ++l) segments_[l].end = next_time;
}

/// One segment a lane: the mean of rows first..last, constant.
void Link::hold(const History& source, std::int64_t first, std::int64_t last, Signal* slots) {
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const Lane& lane = lanes_[l];
    double sum = 0.0;
    for (std::int64_t row = first; row <= last; ++row)
      sum += source.values(row)[static_cast<std::size_t>(lane.output)];
    segments_[l].origin = source.time(last);
    segments_[l].c[0] = lane.gain * (sum / static_cast<double>(last - first + 1)) + lane.offset;
    slots[lane.slot] = Signal(&segments_[l], 1, 0);
  }
}

std::int64_t Link::oldest_needed(const History& source, double time) {
  if (follows_) {
    advance_cursor(time);
    return std::min(cursor_, end_ - how_.samples());
  }
  std::int64_t row = source.newest();
  if (how_.kind == Reconstruction::Kind::mean)
    while (row > source.oldest() && !tolerance_.before(source.time(row), time)) --row;
  return row;
}

void Link::reach_back() { cursor_ = std::min(base_ + how_.samples(), end_) - 1; }

void Link::follow_room(const History& source) {
  if (!follows_) return;
  const std::int64_t keep = std::max(source.oldest(), base_);
  std::vector<Segment> larger;
  std::vector<Segment>& target = source.capacity() == capacity_ ? segments_ : larger;
  target.resize(lanes_.size() * static_cast<std::size_t>(source.capacity()));
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const Segment* first = segments(l) + (keep - base_);
    std::copy(first, first + (end_ - keep),
              target.data() + static_cast<std::ptrdiff_t>(l) * source.capacity());
  }
  if (&target == &larger) segments_ = std::move(larger);
  capacity_ = source.capacity();
  base_ = keep;
  cursor_ = std::max(cursor_, base_);
}

}  // namespace tandem
