// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/link.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tandem {
namespace {
constexpr double open_end = std::numeric_limits<double>::infinity();
}

Link::Link(int source, int reader, Reconstruction how, double delay)
    : degree_(how.polynomial_degree()),
      follows_(how.follows_samples()),
      held_(how.kind == Reconstruction::Kind::held),
      plain_(follows_ && !held_),
      extend_(extend_by(how)),
      delay_(delay),
      source_(source),
      reader_(reader),
      how_(how) {}

void Link::pass_over(double nearest) {
  nearest_ = nearest, plain_ = false;
  joins_ = how_.kind == Reconstruction::Kind::lagrange || how_.kind == Reconstruction::Kind::hermite;
  if (joins_) degree_ = std::max(degree_, 1);
}

void Link::attach(const History& samples, TimeTolerance tolerance) {
  tolerance_ = tolerance;
  samples_ = &samples;
  stride_ = samples.stride();
  joins_ = joins_ && !within_;
  capacity_ = follows_ ? segments_of_lane() : 1;
  segments_.assign(lanes_.size() * static_cast<std::size_t>(capacity_), Segment{});
  differences_.assign(lanes_.size() * TANDEM_MAX_COEFFICIENTS, 0.0);
  first_ = segments_.data();
  if (nearest_ > 0.0) nodes_.resize(static_cast<std::size_t>(std::max(how_.samples(), 2) * stride_));
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
    case Reconstruction::Kind::taylor:
      return extend_taylor;
    case Reconstruction::Kind::least_squares:
      return extend_least_squares;
    default:
      return [](Link&, NewRows) {};  // made when it is read
  }
}

/// A marked row without another before it at its time cuts every lane.
bool Link::jumps(const double* row, const Lane& lane) const {
  if (row[1] == 0.0) return false;
  if (row == samples_->row(samples_->oldest())) return true;
  const double* const before = row - stride_;
  const std::int64_t k = Samples::header + lane.output;
  return before[0] != row[0] || before[k] != row[k];
}

bool Link::jump_near(const double* row) const {
  const std::int64_t last = std::min<std::int64_t>(fitted_, rows_looked_at() - 1);
  for (std::int64_t k = 0; k <= last; ++k, row -= stride_)
    if (row[1] != 0.0) return true;
  return false;
}

/// The rows that a polynomial at this one goes through, the oldest first, to the end of nodes_. None lies
/// before the last jump of `lane` (null: no row near this one is a jump). The row of that jump is passed over
/// for no other than this one; where both ends of a step are joined, for none of these.
void Link::gather_nodes(const double* row, const Lane* lane, bool joined) {
  const int fixed = joined ? 2 : 1, most = std::max(how_.samples(), fixed);
  gathered_ = 0;
  double* node = nodes_.data() + nodes_.size();
  const double* newer = nullptr;
  const std::int64_t last = std::min<std::int64_t>(fitted_, rows_looked_at() - 1);
  for (std::int64_t k = 0; k <= last && gathered_ < most; ++k, row -= stride_) {
    const bool first = lane && jumps(row, *lane), close = k >= fixed && *newer - *row < nearest_;
    if (close && !first) continue;
    if (close && joined && gathered_ == fixed) return;
    if (close && gathered_ > 1) --gathered_, node += stride_;
    newer = row;
    node = std::copy_n(row, stride_, node - stride_) - stride_;
    ++gathered_;
    if (first) return;
  }
}

/// Whether what joins this row and the one before is another polynomial than that which goes on from here.
bool Link::joins_step_to(const double* row) const {
  if (!joins_ || fitted_ == 0) return false;
  const double before = *(row - stride_), shortest = how_.samples() > 1 ? nearest_ : 2.0 * nearest_;
  return tolerance_.before(before, *row) && *row - before < shortest;
}

/// The segment behind the last one, that of the newest row, is for whatever is past it.
void Link::go_on_behind(std::int32_t last) {
  Segment* s = first_ + (last + 1);
  for (std::size_t l = 0; l < lanes_.size(); ++l, s += capacity_) s->end = open_end, mark_jump(*s, false);
}

/// That of the newest row, and what goes on behind it, which is no longer there.
void Link::renew_last() {
  if (!joins_) return;
  --count_, --fitted_;
  extend({samples_->row(samples_->newest()), 1});
}

double Link::newest_jump() const {
  const double* const row = samples_->row(samples_->newest());
  double largest = 0.0;
  for (const Lane& lane : lanes_) {
    const std::int64_t k = Samples::header + lane.output;
    if (jumps(row, lane)) largest = std::max(largest, std::abs(lane.gain * (row[k] - row[k - stride_])));
  }
  return largest;
}

/// Segments that the reader has let go are still there, as nothing has been added since. One stays for a
/// reader that stands past where the source goes back to.
void Link::withdraw(std::int64_t rows) {
  if (!follows_) return;
  if (!held_) fitted_ -= rows;
  count_ -= static_cast<std::int32_t>(rows);
  if (count_ < 1) first_ += count_ - 1, count_ = 1;
  renew_last();
  for (std::size_t l = 0; held_ && l < lanes_.size(); ++l)
    first_[static_cast<std::int64_t>(l) * capacity_ + count_ - 1].end = open_end;
}

void Link::rebuild() {
  if (!follows_) return;
  first_ = segments_.data();
  count_ = 0, fitted_ = 0;
  extend({samples_->row(samples_->oldest()), samples_->newest() + 1 - samples_->oldest()});
}

std::int64_t Link::oldest_to_rebuild(double time) const {
  std::int64_t row = samples_->newest();
  while (row > samples_->oldest() && !tolerance_.before(samples_->time(row) + delay_, time)) --row;
  return row + 1 - rows_kept();
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
    return row + 1 - late_ - std::max(count_, rows_kept());
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

/// The segments of all rows that are there stay, also those that the reader has let go: it may stand past
/// where the source goes back to.
void Link::follow_room() {
  if (!follows_) return;
  const std::int64_t old = let_go(), capacity = segments_of_lane();
  LineVector<Segment> larger;
  LineVector<Segment>& target = capacity == capacity_ ? segments_ : larger;
  target.resize(lanes_.size() * static_cast<std::size_t>(capacity));
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const Segment* first = first_ - old + static_cast<std::int64_t>(l) * capacity_;
    std::copy(first, first + old + count_ + (goes_on_ ? 1 : 0),
              target.data() + static_cast<std::int64_t>(l) * capacity);
  }
  if (&target == &larger) segments_ = std::move(larger);
  capacity_ = capacity;
  first_ = segments_.data() + old;
}

}  // namespace tandem
