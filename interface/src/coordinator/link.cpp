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
      held_(how.kind == Reconstruction::Kind::held),
      plain_(follows_ && !held_),
      delay_(delay) {}

void Link::attach(const History& samples, TimeTolerance tolerance) {
  tolerance_ = tolerance;
  samples_ = &samples;
  stride_ = samples.stride();
  capacity_ = follows_ ? samples_->capacity() : 1;
  segments_.assign(lanes_.size() * static_cast<std::size_t>(capacity_), Segment{});
  differences_.assign(lanes_.size() * TANDEM_MAX_COEFFICIENTS, 0.0);
  first_ = segments_.data();
  if (nearest_ > 0.0) nodes_.resize(static_cast<std::size_t>(how_.samples() * stride_));
}

Link::Extend Link::extend_by(Reconstruction how) {
  constexpr Extend lagrange[] = {extend_lagrange<0>, extend_lagrange<1>, extend_lagrange<2>,
                                 extend_lagrange<3>, extend_lagrange<4>};
  switch (how.kind) {
    case Reconstruction::Kind::lagrange:
      return lagrange[how.degree];
    case Reconstruction::Kind::held:
      return extend_held;
    case Reconstruction::Kind::hermite:
      return extend_hermite;
    case Reconstruction::Kind::least_squares:
      return extend_least_squares;
    default:
      return [](Link&, NewRows) {};  // made when it is read
  }
}

/// The rows that a polynomial at this one goes through, the oldest first, at the end of nodes_; their number.
/// before: rows before it that may be fitted together with it.
int Link::gather_nodes(const double* row, std::int64_t before) {
  const int most = how_.samples();
  int count = 0;
  const double* newer = nullptr;
  const std::int64_t last = std::min<std::int64_t>(before, rows_looked_at() - 1);
  for (std::int64_t k = 0; k <= last && count < most; ++k, row -= stride_) {
    if (newer && *newer - *row < nearest_) continue;
    newer = row;
    std::copy_n(row, stride_, nodes_.data() + (most - ++count) * stride_);
  }
  return count;
}

void Link::extend_late() {
  const std::int64_t rows = std::exchange(late_, 0);
  if (rows > 0) extend({samples_->row(samples_->newest() + 1 - rows), rows});
}

std::int64_t Link::oldest_needed(double time) {
  if (!been_read_) return samples_->oldest();
  std::int64_t row = samples_->newest();
  if (follows_) {
    if (!held_ && !sampled_) forget_before(time);
    return row + 1 - late_ - std::max(count_, rows_looked_at());
  }
  if (how_.kind == Reconstruction::Kind::mean)
    while (row > samples_->oldest() && !tolerance_.before(samples_->time(row), sampled_ ? read_from_ : time))
      --row;
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
