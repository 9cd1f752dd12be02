// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "tandem/engine/description.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::engine {

/// A diagram whose states somebody else integrates, as FMI's Model Exchange has it (FMI 2.0, chapter 3): it says how
/// fast they change and which signals are to be watched, and does what happens at events. Whatever evaluates may throw
/// Error(numerical), as Simulation does.
class Exchanged {
 public:
  /// - step: the own step that the diagram has elsewhere [s], beside which a step after a bounce is short.
  /// Throws Error(not_supported) for a diagram with blocks that go by own steps or by the past of signals (delay,
  /// memory), and as compile().
  Exchanged(const Description& diagram, double step, const SimulationSettings& settings = {});

  const Program& program() const { return program_; }
  double own_step() const { return step_; }  ///< [s]; of a sampled diagram its shortest period

  /// From here on, as long as it is not set again.
  void set_input(int k, double value);
  /// All as at the start, t [s], on these inputs.
  void start(double t);
  /// To a time, and to states, that are tried; nothing happens on the way.
  void go_to(double t);
  void set_states(std::span<const double> x);

  double time() const { return time_; }
  std::span<const double> states();
  void rates(double* dx);
  double output(int k);
  /// A number of the sign of Program::crossings[k], never zero.
  double watched(int k);
  /// The integrator has come here, and stays: refuses signals that are not finite or outside of where they are known.
  void arrive();
  /// What is due here happens.
  void act();
  /// When something is due that is known beforehand [s]; infinity: nothing is.
  double next_event();

  /// All that it goes by but for its inputs, and back.
  const std::vector<double>& keep() const { return simulation_.signals(); }
  void restore(double t, std::span<const double> state);

 private:
  struct Held final : InputSource {
    void at(double, double* to) override { std::copy(values.begin(), values.end(), to); }
    std::vector<double> values;
  };
  enum class Known { nothing, rates, all };
  void evaluate();

  Program program_;
  Held inputs_;
  Simulation simulation_;
  double step_, time_ = 0.0;
  Known known_ = Known::nothing;
};

}  // namespace tandem::engine
