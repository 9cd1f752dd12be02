// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "seeded_samples.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"

namespace tandem::stability {

/// The newest instant up to `begin` is number 0 where it is there, else -1.
std::vector<double> SeededSamples::row_of(std::int64_t k) const { return past((is_past(0) ? 0 : -1) - k); }

Clock SeededSamples::initialize(double t_start, double t_stop, std::span<const double>, Samples& y) {
  tolerance_ = TimeGrid(t_start, step()).tolerance();
  stop_ = t_stop, time_ = t_start, entered_ = false;
  next_ = static_cast<std::int64_t>(std::floor((t_start - instant(0)) / step())) - 1;
  while (tolerance_.before(instant(next_), t_start)) ++next_;
  newest_ = {row_of(next_ - 1)};
  std::copy(newest_[0].begin(), newest_[0].end(), y.append(t_start));
  return {time_, std::max(instant(next_), t_start), Stop::limit};
}

Clock SeededSamples::advance(double, bool, std::span<const Signal>, Samples&) {
  throw Error(ErrorCode::internal, "subsystem '" + info().name + "' is sampled and takes no own steps");
}

void SeededSamples::enter(std::span<const double> u) {
  std::vector<double> row(static_cast<std::size_t>(info().row_size()));
  Samples unused(row.data(), info().row_size(), 1);
  const Clock clock = inner().initialize(begin(), stop_, u, unused);
  if (is_past(0)) inner().sample(clock.next_time, SamplePart::both, u, row);
  inner().set_states(seeded_states());
  entered_ = true;
}

Clock SeededSamples::sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) {
  if (!is_past(next_) && !entered_) enter(u);
  if (entered_)
    inner().sample(t, part, u, y);
  else if (part != SamplePart::states)
    std::ranges::copy(row_of(next_), y.begin());
  if (part != SamplePart::states) now_.assign(y.begin(), y.end());
  if (part != SamplePart::outputs) newest_.push_back(now_), time_ = t, ++next_;
  return {time_, instant(next_), Stop::limit};
}

}  // namespace tandem::stability
