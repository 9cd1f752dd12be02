// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/history.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "../number_text.hpp"
#include "named.hpp"
#include "tandem/error.hpp"

namespace tandem {

History::History(std::string name, const SubsystemInfo& info, std::int64_t capacity)
    : bounds_(info),
      name_(std::move(name)),
      info_(&info),
      outputs_(info.output_size()),
      derivatives_(info.derivatives()) {
  capacity = std::max(capacity, min_capacity);
  data_.resize(static_cast<std::size_t>(capacity * info.row_size()));
  samples_ = Samples(data_.data(), info.row_size(), capacity);
}

/// The call that gave the rows began at the one before them; without one it was the start.
void History::fail(const NewRows& rows, double t_limit, const std::string& what) const {
  const bool start = rows.first == data_.data();
  throw Error(ErrorCode::numerical, (start ? "subsystem '" + name_ + "', initialize"
                                           : advance_of(name_, *(rows.first - stride()), t_limit)) +
                                        ": " + what);
}

/// Throws if there is something wrong with the next row. (The first row and one after a jump have no earlier
/// time.)
void History::check(const NewRows& rows, double t_limit, const TimeTolerance& tolerance) {
  const std::int64_t row = committed_;
  const double t = time(row);
  const auto y = values(row);
  bool finite = std::isfinite(t);
  for (const double v : y) finite &= std::isfinite(v);
  if (!finite) {
    const auto bad = std::find_if(y.begin(), y.end(), [](double v) { return !std::isfinite(v); });
    const auto column = static_cast<int>(bad - y.begin());
    const std::string value =
        bad == y.end() ? "a time that is" : scalar_at(info_->outputs, column % outputs_).name();
    fail(rows, t_limit,
         "it gave " + value + (column >= outputs_ ? " (a derivative)" : "") +
             " not finite at t = " + number_text(t) + " s");
  }
  bounds_.check(name_, t, y);
  if (tolerance.before(t_limit, t))
    fail(rows, t_limit,
         "it gave a sample at t = " + number_text(t) + " s, past its limit " + number_text(t_limit) + " s");
  if (const double flag = this->row(row)[1]; flag != 0.0 && flag != 1.0)
    fail(rows, t_limit,
         "it gave " + number_text(flag) + " as the jump flag of its sample at t = " + number_text(t) +
             " s; allowed is 0 or 1");
  if (row == base_ || t > time(row - 1) || (jump(row) && t == time(row - 1))) return;
  fail(rows, t_limit,
       "it gave a sample at t = " + number_text(t) + " s that does not come after the one before it, at " +
           number_text(time(row - 1)) + " s");
}

/// Column c = m outputs + i, the m-th derivative of output i, at the time s after the sample:
/// sum over n >= m of y^(n) s^(n-m) / (n-m)!.
double History::taylor(const std::vector<double>& sample, int c, double s) const {
  const int m = c / outputs_, i = c % outputs_;
  double value = 0.0;
  for (int n = derivatives_; n >= m; --n)
    value = sample[static_cast<std::size_t>(n * outputs_ + i)] + value * (s / (n - m + 1));
  return value;
}

void History::seed(int count, double h) {
  assert(committed_ - base_ == 1 && h > 0.0 && count + 2 < capacity());
  const std::vector<double> first(values(base_).begin(), values(base_).end());
  const double t0 = time(base_);
  clear();
  for (int k = count; k >= 0; --k) {
    double* y = samples_.append(t0 - k * h);
    for (std::size_t c = 0; c < first.size(); ++c) y[c] = taylor(first, static_cast<int>(c), -k * h);
  }
  seeds_ = count;
}

void History::seed(std::span<const double> past) {
  assert(committed_ - base_ == 1);
  const std::vector<double> first(row(base_), row(base_) + stride());
  clear();
  std::copy(past.begin(), past.end(), data_.begin());
  std::copy(first.begin(), first.end(), data_.begin() + std::ssize(past));
  seeds_ = std::ssize(past) / stride();
  samples_.set_size(seeds_ + 1);
}

void History::clear() {
  base_ = committed_ = seeds_ = 0;
  samples_ = Samples(data_.data(), stride(), capacity());
}

void History::make_room(std::int64_t keep, std::int64_t wanted) {
  keep = std::clamp(keep, base_, committed_);
  const std::int64_t kept = base_ + samples_.size() - keep;
  std::int64_t capacity = this->capacity();
  while (kept + wanted > capacity / 2) capacity *= 2;
  const double* const first = row(keep);
  std::copy(first, first + kept * stride(), data_.begin());
  data_.resize(static_cast<std::size_t>(capacity * stride()));
  base_ = keep;
  samples_ = Samples(data_.data(), stride(), capacity, kept);
}

}  // namespace tandem
