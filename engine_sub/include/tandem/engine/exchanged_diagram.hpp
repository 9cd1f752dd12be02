// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "tandem/engine/description.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::engine {

/// A diagram whose states somebody else integrates, as FMI's Model Exchange has it (FMI 2.0, chapter 3): it
/// says how fast they change and which signals are to be watched, and does what happens at events. Whatever
/// evaluates may throw Error(numerical), as Simulation does.
class ExchangedDiagram {
 public:
  /// What of the signals is as inputs, time and states are.
  enum class Known : std::uint8_t { nothing, rates, all };

  /// - step: the own step that the diagram has elsewhere [s]. After a bounce a millionth of it is looked at.
  /// Throws Error(not_supported) for a diagram with blocks that go by own steps or by the past of signals
  /// (memory, delay), and as compile().
  ExchangedDiagram(const Description& diagram, double step, const SimulationSettings& settings = {});

  const Program& program() const { return program_; }
  double own_step() const { return step_; }  ///< [s]; of a sampled diagram its shortest period

  /// From here on, as long as it is not set again.
  void set_input(int k, double value);
  /// All as at the start, t [s], on these inputs, before what is due there: act() does that.
  void start(double t);
  /// To a time, and to program().states states, that are tried; nothing happens on the way.
  void go_to(double t);
  void set_states(std::span<const double> x);

  std::span<const double> states();
  /// dx: program().states numbers, per second.
  void rates(double* dx);
  double output(int k);
  /// A number of the sign of Program::crossings[k], never zero.
  double watched(int k);
  /// The integrator has come here, and stays: refuses signals that are not finite, or outside of where they
  /// are known.
  void arrive();
  /// What is due here happens. If it throws, start() or restore() is what may follow.
  void act();
  /// After start() or act(): when something is due that is known beforehand [s]; infinity: nothing is.
  double next_event();

  /// All that it goes by but for its inputs, and back; of a diagram that was started at the same time.
  const std::vector<double>& state() const { return simulation_.signals(); }
  const std::vector<double>& guesses() const { return guesses_; }
  Known known() const { return known_; }
  void restore(double t, std::span<const double> state, std::span<const double> guesses, Known known);

 private:
  struct Held final : InputSource {
    void at(double, double* to) override { std::copy(values.begin(), values.end(), to); }
    std::vector<double> values;
  };
  void evaluate();
  System& as_tried();
  void keep_guesses();

  Program program_;
  Held inputs_;
  Simulation simulation_;
  double step_, time_ = 0.0;
  /// What solved the algebraic loops where the integrator was last: from there a try solves them, so that it
  /// does not depend on tries before.
  std::vector<double> guesses_;
  Known known_ = Known::nothing;
};

}  // namespace tandem::engine
