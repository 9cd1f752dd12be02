// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "seeded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "seeded_samples.hpp"
#include "tandem/error.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::stability {

void Seeded::seed(std::vector<std::vector<double>> past, std::vector<double> states) {
  past_ = std::move(past), states_ = std::move(states);
}

double Seeded::sample(int age, int index) const {
  return newest_[newest_.size() - 1 - static_cast<std::size_t>(age)][static_cast<std::size_t>(index)];
}

std::vector<double> Seeded::past(std::int64_t age) const {
  const auto at = static_cast<std::size_t>(age);
  return at < past_.size()
             ? past_[at]
             : std::vector<double>(static_cast<std::size_t>(info().row_size() - Samples::header));
}

namespace {

/// One that integrates itself.
class SeededSteps final : public Seeded {
 public:
  using Seeded::Seeded;
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;

 private:
  void give(Samples& y);
  void enter(std::span<const Signal> u);
  Clock go_on(double t_limit, bool land, std::span<const Signal> u, Samples& y);

  double stop_ = 0.0;
  TimeGrid grid_;
  std::int64_t given_ = 0;
  std::int64_t before_ =
      0;  ///< samples up to `begin` of the run before, which tells this one which of them is the newest; 0: all
  bool entered_ = false;
};

void SeededSteps::give(Samples& y) {
  const bool here = !grid_.tolerance().before(grid_.time(), begin());
  newest_.push_back(past(std::max<std::int64_t>(before_ - 1 - given_++, 0)));
  std::copy(newest_.back().begin(), newest_.back().end(), y.append(here ? begin() : grid_.time()));
}

Clock SeededSteps::initialize(double t_start, double t_stop, std::span<const double>, Samples& y) {
  if (entered_) before_ = given_;
  grid_ = TimeGrid(t_start, step());
  stop_ = t_stop, given_ = 0, entered_ = false;
  newest_.clear();
  give(y);
  return {grid_.time(), grid_.next(), Stop::limit};
}

void SeededSteps::enter(std::span<const Signal> u) {
  std::vector<double> u0, row(static_cast<std::size_t>(info().row_size()));
  for (const Signal& input : u) u0.push_back(input.value(begin()));
  Samples unused(row.data(), info().row_size(), 1);
  inner().initialize(begin(), stop_, u0, unused);
  inner().set_states(seeded_states());
  entered_ = true;
}

Clock SeededSteps::go_on(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  const std::int64_t first = y.size();
  const Clock clock = inner().advance(t_limit, land, u, y);
  if (clock.stop == Stop::event)
    throw Error(ErrorCode::not_supported,
                fmt::format("subsystem '{}' has an event at {} s, within the super-step, "
                            "and an event is no linear map",
                            info().name, clock.time));
  for (std::int64_t row = first; row < y.size(); ++row) {
    if (y.jump(row))
      throw Error(
          ErrorCode::not_supported,
          fmt::format(
              "subsystem '{}' has an output that jumps with a held input, which the map of a super-step "
              "does not know",
              info().name));
    newest_.emplace_back(y.values(row).begin(), y.values(row).end());
  }
  return clock;
}

Clock SeededSteps::advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  while (!y.full()) {
    if (!entered_ && !grid_.tolerance().before(grid_.time(), begin())) enter(u);
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

}  // namespace

std::unique_ptr<Seeded> make_seeded(Subsystem& inner, double begin, double step, double offset) {
  if (inner.info().abilities.sampled) return std::make_unique<SeededSamples>(inner, begin, step, offset);
  return std::make_unique<SeededSteps>(inner, begin, step);
}

}  // namespace tandem::stability
