// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/link.hpp"

#include <algorithm>
#include <utility>

namespace tandem {

Link::Link(int source, int reader, Reconstruction how, double delay)
    : source_(source),
      reader_(reader),
      how_(how),
      extend_(extend_by(how)),
      degree_(how.polynomial_degree()),
      follows_(how.follows_samples()),
      delay_(delay) {}

void Link::attach(const History& samples, TimeTolerance tolerance) {
  tolerance_ = tolerance;
  samples_ = &samples;
  stride_ = samples.stride();
  capacity_ = follows_ ? samples_->capacity() : 1;
  segments_.assign(lanes_.size() * static_cast<std::size_t>(capacity_), Segment{});
  differences_.assign(lanes_.size() * TANDEM_MAX_COEFFICIENTS, 0.0);
  first_ = segments_.data();
}

Link::Extend Link::extend_by(Reconstruction how) {
  constexpr Extend lagrange[] = {extend_lagrange<0>, extend_lagrange<1>, extend_lagrange<2>,
                                 extend_lagrange<3>, extend_lagrange<4>};
  switch (how.kind) {
    case Reconstruction::Kind::lagrange:
      return lagrange[how.degree];
    case Reconstruction::Kind::hermite:
      return extend_hermite;
    case Reconstruction::Kind::least_squares:
      return extend_least_squares;
    default:
      return [](Link&, NewRows) {};  // made when it is read
  }
}

/// Mean: the rows in [time, next_time], else the newest before. Matched hold: the newest row.
void Link::read_window(double time, double next_time, Signal* slots) {
  std::int64_t first = samples_->newest(), last = first;
  if (how_.kind == Reconstruction::Kind::mean) {
    while (last > samples_->oldest() && tolerance_.before(next_time, samples_->time(last))) --last;
    first = last;
    while (first > samples_->oldest() && !tolerance_.before(samples_->time(first - 1), time)) --first;
  }
  hold(first, last, slots);
  for (std::size_t l = 0; l < lanes_.size(); ++l) segments_[l].end = next_time;
}

/// One segment a lane: the mean of rows first..last, constant.
void Link::hold(std::int64_t first, std::int64_t last, Signal* slots) {
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const Lane& lane = lanes_[l];
    double sum = 0.0;
    for (std::int64_t row = first; row <= last; ++row)
      sum += samples_->values(row)[static_cast<std::size_t>(lane.output)];
    segments_[l].origin = samples_->time(last);
    segments_[l].c[0] = lane.gain * (sum / static_cast<double>(last - first + 1)) + lane.offset;
    slots[lane.slot] = Signal(&segments_[l], 1, 0);
  }
}

std::int64_t Link::oldest_needed(double time) {
  if (!been_read_) return samples_->oldest();
  std::int64_t row = samples_->newest();
  if (follows_) {
    forget_before(time);
    return row + 1 - std::max(count_, how_.samples());
  }
  if (how_.kind == Reconstruction::Kind::mean)
    while (row > samples_->oldest() && !tolerance_.before(samples_->time(row), time)) --row;
  return row;
}

void Link::reach_back() {
  const std::int32_t before = std::min(how_.samples(), count_) - 1;
  first_ += before;
  count_ -= before;
}

void Link::follow_room() {
  if (!follows_) return;
  std::vector<Segment> larger;
  std::vector<Segment>& target = samples_->capacity() == capacity_ ? segments_ : larger;
  target.resize(lanes_.size() * static_cast<std::size_t>(samples_->capacity()));
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const Segment* first = first_ + static_cast<std::int64_t>(l) * capacity_;
    std::copy(first, first + count_, target.data() + static_cast<std::int64_t>(l) * samples_->capacity());
  }
  if (&target == &larger) segments_ = std::move(larger);
  capacity_ = samples_->capacity();
  first_ = segments_.data();
}

}  // namespace tandem
