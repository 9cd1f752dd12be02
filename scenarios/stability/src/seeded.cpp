// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "seeded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tandem/error.hpp"

namespace tandem::stability {

Seeded::Seeded(Subsystem& inner, double begin, double step) : inner_(inner), begin_(begin), step_(step) {}

void Seeded::seed(std::vector<std::vector<double>> past, std::vector<double> states) {
  past_ = std::move(past), states_ = std::move(states);
}

double Seeded::sample(int age, int index) const {
  return newest_[newest_.size() - 1 - static_cast<std::size_t>(age)][static_cast<std::size_t>(index)];
}

void Seeded::give(Samples& y) {
  const auto width = static_cast<std::size_t>(info().row_size() - Samples::header);
  const auto age = static_cast<std::size_t>(before_ - 1 - given_++);
  const bool here = !grid_.tolerance().before(grid_.time(), begin_);
  newest_.push_back(age < past_.size() ? past_[age] : std::vector<double>(width, 0.0));
  std::copy(newest_.back().begin(), newest_.back().end(), y.append(here ? begin_ : grid_.time()));
}

Clock Seeded::initialize(double t_start, double t_stop, std::span<const double>, Samples& y) {
  if (entered_) before_ = given_;
  grid_ = TimeGrid(t_start, step_);
  stop_ = t_stop, given_ = 0, entered_ = false;
  newest_.clear();
  give(y);
  return {grid_.time(), grid_.next(), Stop::limit};
}

void Seeded::enter(std::span<const Signal> u) {
  std::vector<double> u0, row(static_cast<std::size_t>(info().row_size()));
  for (const Signal& input : u) u0.push_back(input.value(begin_));
  Samples unused(row.data(), info().row_size(), 1);
  inner_.initialize(begin_, stop_, u0, unused);
  inner_.set_states(states_);
  entered_ = true;
}

Clock Seeded::go_on(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  const std::int64_t first = y.size();
  const Clock clock = inner_.advance(t_limit, land, u, y);
  if (clock.stop == Stop::event)
    throw Error(ErrorCode::not_supported,
                fmt::format("subsystem '{}' has an event at {} s, within the super-step, "
                            "and an event is no linear map",
                            info().name, clock.time));
  for (std::int64_t row = first; row < y.size(); ++row)
    newest_.emplace_back(y.values(row).begin(), y.values(row).end());
  return clock;
}

Clock Seeded::advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  while (!y.full()) {
    if (!entered_ && !grid_.tolerance().before(grid_.time(), begin_)) enter(u);
    if (entered_) return go_on(t_limit, land, u, y);
    if (grid_.fits(t_limit))
      grid_.step();
    else if (land && grid_.cuts(t_limit))
      grid_.cut(t_limit);
    else
      return {grid_.time(), grid_.next(), Stop::limit};
    give(y);
  }
  return {grid_.time(), grid_.next(), Stop::samples_full};
}

}  // namespace tandem::stability
