// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/outputs.hpp"

namespace tandem::mbs {

/// Takes a sentence that is told once: a signal has left its limits.
using TellOfLimit = std::function<void(const std::string&)>;

/// Of one signal: what tells that it has left its limits.
struct Bound {
  std::string signal, unit;  ///< "limit 'rolled': signal 'roll'", "rad"
  double low, high;
  std::string sentence;
  bool stops = false;
};

/// Signals that are looked at where a model stands.
class Bounds {
 public:
  /// tell: null for nobody.
  explicit Bounds(std::vector<Bound> bounds = {}, TellOfLimit tell = {});
  std::size_t size() const { return bounds_.size(); }
  /// values: one for each. The first time that one is beyond its limits it is told, or, if it stops,
  /// Error(numerical) thrown, with signal, value, limit, time and sentence.
  void look(const double* values, double time);

 private:
  std::vector<Bound> bounds_;
  std::vector<bool> was_told_;
  TellOfLimit tell_;
};

/// The limits of a mechanism's description.
class Limits {
 public:
  /// `mechanism` must outlive it.
  Limits(const Mechanism& mechanism, TellOfLimit tell);
  /// As Outputs::start().
  void start(const State& state);
  /// Of a state that is complete, as Outputs::evaluate() needs it.
  void look(const State& state);

 private:
  std::optional<Outputs> signals_;  ///< if there are any
  Bounds bounds_;
  std::vector<double> values_;
};

}  // namespace tandem::mbs
