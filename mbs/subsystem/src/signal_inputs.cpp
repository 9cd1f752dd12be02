// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "signal_inputs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tandem::mbs {
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
  return {signal.value(t), signal.derivative(t), signal.second_derivative(t)};
}

void SignalInputs::at(double t, std::span<InputValue> values) {
  for (std::size_t port = 0; port < ports_.size(); ++port)
    values[static_cast<std::size_t>(ports_[port])] = value(port, t);
}

bool SignalInputs::read(double t, std::vector<InputValue>& to) const {
  bool changed = false;
  for (std::size_t port = 0; port < ports_.size(); ++port) {
    const InputValue before = std::exchange(to[port], value(port, t));
    changed |= !(before == to[port]);
  }
  return changed;
}

}  // namespace tandem::mbs
