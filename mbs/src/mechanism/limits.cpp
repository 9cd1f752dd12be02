// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/limits.hpp"

#include <fmt/format.h>

#include <utility>

#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

std::vector<Output> signals_of(const Description& in) {
  std::vector<Output> signals;
  for (const Limit& limit : in.limits)
    if (limit.on_leaving != Limit::OnLeaving::ignore) signals.push_back(limit.signal);
  return signals;
}

std::string name_of_signal(const Description& in, const Output& signal) {
  if (signal.kind != Output::Kind::quantity || !signal.name.empty())
    return fmt::format("signal '{}'", signal.name);
  const NamedElement& element = in.elements[static_cast<std::size_t>(signal.element)];
  return fmt::format("{} of element '{}'",
                     element.force->quantities()[static_cast<std::size_t>(signal.quantity)].name,
                     element.name);
}

std::vector<Bound> bounds_of(const Description& in, const Outputs& signals) {
  std::vector<Bound> bounds;
  for (const Limit& limit : in.limits)
    if (limit.on_leaving != Limit::OnLeaving::ignore)
      bounds.push_back({fmt::format("limit '{}': {}", limit.name, name_of_signal(in, limit.signal)),
                        signals.unit(static_cast<int>(bounds.size())), limit.low, limit.high, limit.sentence,
                        limit.on_leaving == Limit::OnLeaving::stop});
  return bounds;
}

}  // namespace

Bounds::Bounds(std::vector<Bound> bounds, TellOfLimit tell)
    : bounds_(std::move(bounds)), was_told_(bounds_.size()), tell_(std::move(tell)) {}

void Bounds::look(const double* values, double time) {
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const Bound& bound = bounds_[k];
    const bool below = values[k] < bound.low;
    if (was_told_[k] || (!below && !(values[k] > bound.high))) continue;
    const std::string text = fmt::format("{} is {:.6g} {}, {} {:g}, from t = {:.10g} s on: {}", bound.signal,
                                         values[k], bound.unit, below ? "below" : "above",
                                         below ? bound.low : bound.high, time, bound.sentence);
    if (bound.stops) throw Error(ErrorCode::numerical, text);
    was_told_[k] = true;
    if (tell_) tell_(text);
  }
}

Limits::Limits(const Mechanism& mechanism, TellOfLimit tell) {
  const Description& in = mechanism.description();
  std::vector<Output> signals = signals_of(in);
  if (signals.empty()) return;
  signals_.emplace(mechanism, std::move(signals));
  bounds_ = Bounds(bounds_of(in, *signals_), std::move(tell));
  values_.resize(bounds_.size());
}

void Limits::start(const State& state) {
  if (signals_) signals_->start(state);
}

void Limits::look(const State& state) {
  if (!signals_) return;
  signals_->evaluate(state, values_.data());
  bounds_.look(values_.data(), state.time);
}

}  // namespace tandem::mbs
