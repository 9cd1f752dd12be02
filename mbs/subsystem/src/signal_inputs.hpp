// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/signal.hpp"

namespace tandem::mbs {

/// Inputs of a mechanism from the signals of a call: one for each input without a function of time, in the
/// order of the description.
class SignalInputs final : public InputSource {
 public:
  explicit SignalInputs(const Description& description);

  /// Inputs of the description by port.
  const std::vector<int>& ports() const { return ports_; }
  /// From here on; they belong to the caller.
  void set(std::span<const Signal> signals) { signals_ = signals; }
  /// Constants, one for each port, in place of signals.
  void set_constants(std::span<const double> values);

  void at(double t, std::span<InputValue> values) override;
  /// Writes what they are at t, and tells whether any of them has changed.
  bool read(double t, std::vector<InputValue>& to) const;

 private:
  InputValue value(std::size_t port, double t) const;

  std::vector<int> ports_;
  std::vector<bool> drives_;  ///< by port: a motion is prescribed, so derivatives are asked for
  std::span<const Signal> signals_;
  std::vector<Segment> constants_;
  std::vector<Signal> constant_signals_;
};

}  // namespace tandem::mbs
