// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "known.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "side_by_side.hpp"
#include "tandem/error.hpp"
#include "tandem/identification/identify.hpp"
#include "tandem/identification/surrogate.hpp"

namespace tandem::identification {
namespace {

/// Nothing: it may have a linear model.
std::string why_not(const SubsystemInfo& info) {
  if (info.abilities.sampled) return "it is sampled";
  if (info.abilities.events) return "it has events";
  if (info.abilities.chooses_step) return "its own steps vary";
  if (!info.abilities.restarts) return "it can't start again";
  return "";
}

/// Responses that last a quarter of the run, where that is not too long.
Wanted wanted(const SubsystemInfo& info, const Clock& start, double t_stop, std::span<const double> u0) {
  constexpr double least = 12.0, most = 1536.0;
  const double steps = 0.25 * (t_stop - start.time) / (start.next_time - start.time);
  Wanted all{start.time, {u0.begin(), u0.end()}, {}};
  all.steps = static_cast<std::int64_t>(std::clamp(steps, least, most));
  for (int k = 0; k < info.row_size() - Samples::header; ++k) all.values.push_back(k);
  return all;
}

std::vector<std::uint64_t> bits(const TimeSpan& span, std::span<const double> u0) {
  std::vector<std::uint64_t> all = {std::bit_cast<std::uint64_t>(span.start),
                                    std::bit_cast<std::uint64_t>(span.stop)};
  for (const double u : u0) all.push_back(std::bit_cast<std::uint64_t>(std::isnan(u) ? std::nan("") : u));
  return all;
}

/// That of the first own step, without what times far from 0 round it by.
double exact_step(Subsystem& real, double step, const TimeSpan& span, std::span<const double> u0) {
  const double rounding =
      4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(span.start), std::abs(span.stop));
  try {
    std::vector<double> row(static_cast<std::size_t>(real.info().row_size()));
    Samples y(row.data(), real.info().row_size(), 1);
    const double from_zero = real.initialize(0.0, span.stop - span.start, u0, y).next_time;
    return std::abs(from_zero - step) <= rounding ? from_zero : step;
  } catch (const Error&) {  // its data begin later
    return step;
  }
}

}  // namespace

void Known::see(const Subsystem& one) {
  const std::lock_guard lock(mutex_);
  if (info_) return;
  stand_.sampled = one.info().abilities.sampled, stand_.why = why_not(one.info());
  may_have_model_ = stand_.why.empty(), one_thread_ = one.one_thread();
  info_ = one.info();
  info_->abilities.serializes_state = info_->abilities.reactive_inputs = false;
}

bool Known::is_seen() const {
  const std::lock_guard lock(mutex_);
  return info_.has_value();
}

Beginning Known::beginning(const TimeSpan& span, std::span<const double> u0, const Opened& real) {
  const auto key = bits(span, u0);
  {
    const std::lock_guard lock(mutex_);
    if (const auto it = beginnings_.find(key); it != beginnings_.end()) return it->second;
  }
  Beginning one{{}, std::vector<double>(static_cast<std::size_t>(info().row_size()))};
  Samples y(one.row.data(), info().row_size(), 1);
  one.clock = real().initialize(span.start, span.stop, u0, y);
  const std::lock_guard lock(mutex_);
  return beginnings_.emplace(key, std::move(one)).first->second;
}

void Known::find(const TimeSpan& span, std::span<const double> u0, const Clock& clock, const Opened& real) {
  std::call_once(found_, [&] {
    try {
      look(real(), span, u0, clock);
    } catch (const Error& error) {
      stand_.modelled = false, stand_.why = error.what();
    }
  });
}

void Known::look(Subsystem& real, const TimeSpan& span, std::span<const double> u0, const Clock& clock) {
  auto found = identify_linear(real, wanted(info(), clock, span.stop, u0));
  if (!found) {
    stand_.why = "it is not linear";
    return;
  }
  if (span.start != 0.0) found->step = exact_step(real, found->step, span, u0);
  stand_.order = static_cast<int>(found->order()), stand_.residual = found->residual;
  if (found->residual <= Models::most_residual)
    keep(real, std::move(*found), {clock.time, span.stop}, u0);
  else
    stand_.why = fmt::format("the best linear model leaves {:.2g} of its responses; allowed is {}",
                             found->residual, Models::most_residual);
}

/// If it goes like the subsystem to the end.
void Known::keep(Subsystem& real, LinearModel found, const TimeSpan& span, std::span<const double> u0) {
  std::call_once(kin_->seen, [&] {
    kin_->apart = apart(real, *make_surrogate(found, info()), span, u0, Models::most_apart);
  });
  stand_.modelled = !kin_->apart;
  if (stand_.modelled)
    models_.emplace(0.0, std::move(found));
  else
    stand_.why = fmt::format(
        "its model is farthest off at t = {:.6g} s, by more than 1e-4 of the peak: it goes by its own clock, "
        "or "
        "is not linear",
        *kin_->apart);
}

const LinearModel* Known::model(double step) {
  const std::lock_guard lock(mutex_);
  const auto own = models_.find(0.0);
  if (own == models_.end()) return nullptr;
  auto it = models_.find(step);
  if (it == models_.end()) it = models_.emplace(step, with_step(*own->second, step)).first;
  return it->second ? &*it->second : nullptr;
}

}  // namespace tandem::identification
