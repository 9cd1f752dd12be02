// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "sort.hpp"

namespace tandem::engine {

/// How the signals of a diagram go on in time: constant from event to event or not, with jumps or without.
class Courses {
 public:
  /// order: of the steps that are alive.
  Courses(const Lowering& diagram, const std::vector<Sequence>& order);

  /// Follows held values and constants alone. (What changes with each own step does not count as held.)
  bool held(int signal) const { return held_[slot(signal)]; }
  /// An event of the diagram may change it at once: a sample, a reset, a switch from one signal to another, a
  /// delay of such a one or of an input. Not so where a limit is reached or left: there it bends.
  bool jumps(int signal) const { return jumps_[slot(signal)]; }

  /// Whether all of them change at periodic events alone, and nothing else in the diagram has a course. What
  /// is limited or switched by a signal that is not held is then only of interest as it is at an instant.
  bool sampled(const std::vector<int>& outputs, const std::vector<bool>& alive) const;

 private:
  std::size_t slot(int signal) const { return static_cast<std::size_t>(d_.resolved(signal)); }
  bool is_held(const Step& step) const;
  bool can_jump(const Step& step) const;
  bool follows_input(int signal) const;
  template <class Of>
  void spread(std::vector<bool>& to, const Of& of);

  const Lowering& d_;
  const std::vector<Sequence>& order_;
  std::vector<bool> held_, jumps_;
};

/// By slot whether an output follows from its value at an instant of a sampled diagram, at that instant: the
/// values before the periodic events, and what these and others make of them.
std::vector<bool> needed_at_instant(const Lowering& diagram, int output);

}  // namespace tandem::engine
