// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "signal_inputs.hpp"

#include <algorithm>
#include <limits>

namespace tandem::mbs {
namespace {

/// The piece that Signal::value(t) evaluates.
const Segment& piece(const Signal& signal, double t) {
  const auto segments = signal.segments();
  const auto at =
      std::find_if(segments.begin(), segments.end() - 1, [t](const Segment& s) { return t <= s.end; });
  return *at;
}

double second_derivative(const Signal& signal, double t) {
  const Segment& s = piece(signal, t);
  double sum = 0.0;
  for (int k = signal.degree(); k >= 2; --k) sum = sum * (t - s.origin) + k * (k - 1) * s.c[k];
  return sum;
}

}  // namespace

SignalInputs::SignalInputs(const Description& in) {
  for (int i = 0; i < static_cast<int>(in.inputs.size()); ++i) {
    if (in.inputs[static_cast<std::size_t>(i)].function) continue;
    ports_.push_back(i);
    drives_.push_back(
        std::any_of(in.drives.begin(), in.drives.end(), [i](const Drive& d) { return d.input == i; }));
  }
  constants_.resize(ports_.size());
  for (Segment& s : constants_) {
    s = {};
    s.end = std::numeric_limits<double>::infinity();
    constant_signals_.emplace_back(&s, 1, 0);
  }
}

void SignalInputs::set_constants(std::span<const double> values) {
  for (std::size_t k = 0; k < constants_.size(); ++k) constants_[k].c[0] = values[k];
  signals_ = constant_signals_;
}

InputValue SignalInputs::value(std::size_t port, double t) const {
  const Signal& signal = signals_[port];
  if (!drives_[port]) return {signal.value(t)};
  return {signal.value(t), signal.derivative(t), second_derivative(signal, t)};
}

void SignalInputs::at(double t, std::span<InputValue> values) {
  for (std::size_t port = 0; port < ports_.size(); ++port)
    values[static_cast<std::size_t>(ports_[port])] = value(port, t);
}

bool SignalInputs::same(double t, std::vector<InputValue>& before) {
  bool same = true;
  for (std::size_t port = 0; port < ports_.size(); ++port) {
    const InputValue now = value(port, t);
    same = same && now == before[port];
    before[port] = now;
  }
  return same;
}

}  // namespace tandem::mbs
