// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output_track.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/subsystem_info.hpp"

namespace tandem {

std::size_t OutputTrack::column(int output) {
  const auto known = std::find(outputs_.begin(), outputs_.end(), output);
  if (known != outputs_.end()) return static_cast<std::size_t>(known - outputs_.begin());
  const bool slopes = scalar_at(info_->outputs, output).port->derivatives > 0;
  outputs_.push_back(output);
  stride_ += 2;
  has_slopes_.push_back(slopes);
  values_.push_back(0.0), rates_.push_back(0.0), cubics_.resize(cubics_.size() + most_nodes);
  any_slopes_ = any_slopes_ || slopes, all_slopes_ = all_slopes_ && slopes;
  return outputs_.size() - 1;
}

void OutputTrack::add(const History& history, std::int64_t first, std::int64_t last) {
  const std::int64_t before = count_;
  count_ += last - first + 1;
  if (static_cast<std::int64_t>(rows_.size()) < count_ * stride_)
    rows_.resize(static_cast<std::size_t>(2 * count_ * stride_));
  double* to = rows_.data() + before * stride_;
  for (std::int64_t row = first; row <= last; ++row, to += stride_) {
    const double *from = history.row(row), *y = from + Samples::header, *slopes = y + history.outputs();
    const bool anew = to == rows_.data() || from[1] != 0.0;
    to[0] = from[0];
    to[1] = anew ? 1.0 : std::min<double>(most_nodes, to[1 - stride_] + 1.0);
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      to[header + 2 * k] = y[outputs_[k]];
      to[header + 2 * k + 1] = has_slopes_[k] ? slopes[outputs_[k]] : 0.0;
    }
  }
}

/// With those that a polynomial through `row` goes through.
void OutputTrack::drop_before(std::int64_t row) {
  constexpr std::int64_t few = 64;
  const std::int64_t old = row - most_nodes - first_;
  if (old < few || 2 * old < count_) return;
  std::copy(rows_.begin() + old * stride_, rows_.begin() + count_ * stride_, rows_.begin());
  first_ += old, count_ -= old;
}

void OutputTrack::fit(std::int64_t row) {
  const double* now = at(row);
  fitted_ = row, origin_ = now[-stride_];
  if (any_slopes_) fit_slopes(now);
  const auto kept = static_cast<double>(row - first_ + 1);
  if (!all_slopes_) fit_nodes(now, static_cast<int>(std::min(now[1], kept)));
}

/// Hermite's, of the step that ends at that row.
void OutputTrack::fit_slopes(const double* row) {
  const double *before = row - stride_, per_h = 1.0 / (row[0] - before[0]);
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    if (!has_slopes_[k]) continue;
    const double *from = before + header + 2 * k, *to = row + header + 2 * k;
    const double mean = (to[0] - from[0]) * per_h, a = from[1] - mean, b = to[1] - mean;
    double* c = &cubics_[most_nodes * k];
    c[0] = from[0], c[1] = from[1], c[2] = -(a + a + b) * per_h, c[3] = (a + b) * per_h * per_h;
  }
}

/// Newton's through that row and those before it, two to four; x counts from the row before.
void OutputTrack::fit_nodes(const double* row, int nodes) {
  const std::ptrdiff_t back = stride_;
  const double x0 = row[0] - origin_, x2 = nodes > 2 ? row[-2 * back] - origin_ : 1.0,
               x3 = nodes > 3 ? row[-3 * back] - origin_ : 1.0;
  const double per_0 = 1.0 / x0, per_2 = 1.0 / x2, per_3 = 1.0 / x3, per_20 = 1.0 / (x2 - x0),
               per_30 = 1.0 / (x3 - x0), per_32 = 1.0 / (x3 - x2);
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    if (has_slopes_[k]) continue;
    const double *y = row + header + 2 * k, from = y[-back], slope = (y[0] - from) * per_0;
    const double bend = nodes > 2 ? ((y[-2 * back] - from) * per_2 - slope) * per_20 : 0.0;
    const double third = nodes > 3 ? (((y[-3 * back] - from) * per_3 - slope) * per_30 - bend) * per_32 : 0.0;
    double* c = &cubics_[most_nodes * k];
    c[0] = from, c[1] = slope - x0 * (bend - third * x2), c[2] = bend - third * (x0 + x2), c[3] = third;
  }
}

void OutputTrack::write(ByteWriter& to) const {
  to.put(first_);
  to.put_list(std::span(rows_).first(static_cast<std::size_t>(count_ * stride_)));
}

void OutputTrack::read(ByteReader& from) {
  first_ = from.take<std::int64_t>(), fitted_ = -1;
  rows_ = from.take_list();
  count_ = static_cast<std::int64_t>(rows_.size()) / stride_;
  bool sound = first_ >= 0 && static_cast<std::int64_t>(rows_.size()) == count_ * stride_;
  for (std::int64_t k = first_; sound && k <= newest(); ++k) {
    const double run = at(k)[1],
                 most = k > first_ ? std::min<double>(most_nodes, at(k - 1)[1] + 1.0) : most_nodes;
    sound = std::isfinite(time(k)) && run >= 1.0 && run <= most && run == std::floor(run) &&
            (k == first_ || time(k - 1) <= time(k));
  }
  if (!sound) from.refuse("has " + std::to_string(count_) + " rows of outputs that do not go together");
}

}  // namespace tandem
