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
  has_slopes_.push_back(slopes);
  values_.push_back(0.0), rates_.push_back(0.0);
  any_slopes_ = any_slopes_ || slopes, all_slopes_ = all_slopes_ && slopes;
  return outputs_.size() - 1;
}

void OutputTrack::add(const History& history, std::int64_t first, std::int64_t last) {
  const std::int64_t before = count_;
  count_ += last - first + 1;
  if (static_cast<std::int64_t>(rows_.size()) < count_ * stride())
    rows_.resize(static_cast<std::size_t>(2 * count_ * stride()));
  double* to = rows_.data() + before * stride();
  for (std::int64_t row = first; row <= last; ++row, to += stride()) {
    const double *from = history.row(row), *y = from + Samples::header, *slopes = y + history.outputs();
    const bool anew = to == rows_.data() || from[1] != 0.0;
    to[0] = from[0];
    to[1] = anew ? 1.0 : std::min<double>(most_nodes, to[1 - stride()] + 1.0);
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
  std::copy(rows_.begin() + old * stride(), rows_.begin() + count_ * stride(), rows_.begin());
  first_ += old, count_ -= old;
}

void OutputTrack::look(std::int64_t row, double t) {
  const double *now = at(row), *before = now - stride();
  const int nodes = std::min(static_cast<int>(now[1]),
                             static_cast<int>(std::min<std::int64_t>(row - first_ + 1, most_nodes)));
  if (any_slopes_) look_between(now, (t - before[0]) / (now[0] - before[0]));
  if (!all_slopes_) look_by_nodes(now, nodes, t);
}

/// The cubic Hermite polynomial at the part x of the step that ends at that row.
void OutputTrack::look_between(const double* row, double x) {
  const double* before = row - stride();
  const double h = row[0] - before[0], z = 1.0 - x, per_h = 1.0 / h;
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    if (!has_slopes_[k]) continue;
    const double *from = before + header + 2 * k, *to = row + header + 2 * k;
    const double rise = to[0] - from[0], mean = rise * per_h;
    const double a = from[1] - mean, b = to[1] - mean, bend = z * a - x * b;
    values_[k] = from[0] + x * (rise + h * z * bend);
    if (wants_rates_) rates_[k] = mean + (z - x) * bend - x * z * (a + b);
  }
}

/// The polynomial through that row and those before it.
void OutputTrack::look_by_nodes(const double* row, int nodes, double t) {
  double values[most_nodes], rates[most_nodes];
  if (wants_rates_ || nodes < most_nodes || !weigh_equal(row, t, values)) weigh(row, nodes, t, values, rates);
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    if (has_slopes_[k]) continue;
    const double* y = row + header + 2 * k;
    values_[k] = rates_[k] = 0.0;
    for (int j = 0; j < nodes; ++j) {
      values_[k] += values[j] * y[-j * stride()];
      if (wants_rates_) rates_[k] += rates[j] * y[-j * stride()];
    }
  }
}

/// Lagrange's polynomials, and their derivatives.
void OutputTrack::weigh(const double* row, int nodes, double t, double* values, double* rates) const {
  const auto node = [&](int k) { return row[-k * stride()]; };
  for (int j = 0; j < nodes; ++j) {
    double value = 1.0, rate = 0.0, whole = 1.0;
    for (int i = 0; i < nodes; ++i) {
      if (i == j) continue;
      const double x = t - node(i);
      rate = rate * x + value;
      value *= x;
      whole *= node(j) - node(i);
    }
    const double scale = 1.0 / whole;
    values[j] = scale * value, rates[j] = scale * rate;
  }
}

/// Those of four nodes as far from each other, without so many divisions. False: they are not.
bool OutputTrack::weigh_equal(const double* row, double t, double* values) const {
  const auto node = [&](int k) { return row[-k * stride()]; };
  const double h = node(0) - node(1), width = 1e-9 * h, x = (t - node(0)) / h;
  if (std::abs(node(1) - node(2) - h) > width || std::abs(node(2) - node(3) - h) > width) return false;
  const double a = x * (x + 1.0), b = (x + 2.0) * (x + 3.0);
  values[0] = (x + 1.0) * b / 6.0, values[1] = -0.5 * x * b;
  values[2] = 0.5 * a * (x + 3.0), values[3] = -a * (x + 2.0) / 6.0;
  return true;
}

void OutputTrack::write(ByteWriter& to) const {
  to.put(first_);
  to.put_list(std::span(rows_).first(static_cast<std::size_t>(count_ * stride())));
}

void OutputTrack::read(ByteReader& from) {
  first_ = from.take<std::int64_t>();
  rows_ = from.take_list();
  count_ = static_cast<std::int64_t>(rows_.size()) / stride();
  bool sound = first_ >= 0 && static_cast<std::int64_t>(rows_.size()) == count_ * stride();
  for (std::int64_t k = first_; sound && k <= newest(); ++k) {
    const double run = at(k)[1],
                 most = k > first_ ? std::min<double>(most_nodes, at(k - 1)[1] + 1.0) : most_nodes;
    sound = std::isfinite(time(k)) && run >= 1.0 && run <= most && run == std::floor(run) &&
            (k == first_ || time(k - 1) <= time(k));
  }
  if (!sound) from.refuse("has " + std::to_string(count_) + " rows of outputs that do not go together");
}

}  // namespace tandem
