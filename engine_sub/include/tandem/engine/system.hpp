// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tandem/differential_system.hpp"
#include "tandem/engine/program.hpp"
#include "tandem/reaction.h"

namespace tandem::engine {

class LoopSolver;

/// Gives the inputs of a diagram as functions of time.
class InputSource {
 public:
  virtual ~InputSource() = default;
  /// One value for each input, in the order of the diagram.
  virtual void at(double t, double* values) = 0;

  /// From t on values are those of one course, smooth up to and with the time that is returned (infinity: for
  /// ever): at() gives that course until the next call, also a little beyond it. Of an integrator that
  /// chooses its steps; without a call at() gives each value as it is.
  virtual double begin_course(double t);

  /// Whether one of them jumps at t, which is more than that two polynomials do not quite meet there.
  virtual bool jump_at(double) { return false; }
};

/// A program with its image, as integrators see it: x' = f(t, x), and signals whose signs are watched. Held
/// values stay as they are. The states stand in the image. What evaluates throws Error(numerical) where an
/// algebraic loop has no solution.
class System final : public DifferentialSystem {
 public:
  /// inputs: may be null where the program has none. Both must outlive the system.
  System(const Program& program, InputSource* inputs);
  ~System() override;
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  int size() const override { return program_.states + reacting_; }
  double* states() override { return image_.data(); }
  std::vector<std::string> state_names() const override { return program_.state_names; }
  const Program& program() const { return program_; }
  std::vector<double>& image() { return image_; }
  const std::vector<double>& image() const { return image_; }

  /// From here on its states are followed by those of a reaction, which is valid until the next call of this; null: by
  /// none. Throws Error(not_supported) where there is no room for them.
  void react(const tandem_reaction* reaction);
  std::span<const double> reaction_states() const {
    return std::span(image_).subspan(static_cast<std::size_t>(program_.states),
                                     static_cast<std::size_t>(reacting_));
  }

  /// Derivatives at t and the image's states.
  void rates(double t, double* dx) override {
    set_time(t);
    run(0, reaction_ ? program_.step_operations : program_.rate_operations);
    read_rates(dx);
  }
  void read_rates(double* dx) {
    for (const int slot : program_.rates) *dx++ = image_[static_cast<std::size_t>(slot)];
    if (reaction_) read_reaction_rates(dx);
  }
  double begin_course(double t) { return inputs_->begin_course(t); }
  bool inputs_jump_at(double t) { return inputs_ && inputs_->jump_at(t); }
  /// Every signal at t, but for those that are needed at events alone.
  void evaluate(double t) override {
    set_time(t);
    run(0, program_.step_operations);
  }
  /// The rest of evaluate(t) after rates(t).
  void evaluate_rest() { run(program_.rate_operations, program_.step_operations); }
  /// These, after evaluate().
  void evaluate_updates() { run(program_.step_operations, static_cast<int>(program_.operations.size())); }
  /// The same after evaluate(t) and changes of the inputs alone; nothing, if there are none.
  void evaluate_again(double t) override {
    if (inputs_ && inputs_change(t)) evaluate(t);
  }

  /// After evaluate(): the number of the first crossing from `first` on whose signal has another sign than it
  /// was last seen with; -1 for none. A signal that is zero keeps its sign, likewise one that follows from an
  /// algebraic loop and is within its errors.
  int changed(int first) const;
  int changed() const override { return changed(0); }
  std::string not_finite() const override {
    return program_.not_finite(image_.data(), static_cast<int>(program_.operations.size()));
  }
  double watched(int crossing) const;
  /// The same, but for zero a number next to it of the sign that it keeps.
  double watched_sign(int crossing) const;
  void watched_signs(double* signs) const override {
    for (int k = 0; k < watched_signals(); ++k) signs[k] = watched_sign(k);
  }
  int watched_signals() const override { return static_cast<int>(program_.crossings.size()); }
  /// The largest tolerance of its algebraic loops.
  double rate_error() const override;

 private:
  void run(int first, int last) {
    loops_.empty() ? program_.run(image_.data(), first, last) : run_with_loops(first, last);
  }
  void run_with_loops(int first, int last);
  double band(const Crossing& crossing, double times) const;
  bool inputs_change(double t);
  void read_reaction_rates(double* dz);
  void set_time(double t) {
    image_[static_cast<std::size_t>(program_.time)] = t;
    if (inputs_) inputs_->at(t, image_.data() + program_.time + 1);
  }

  const Program& program_;
  InputSource* inputs_;
  std::vector<double> image_, inputs_now_, outputs_now_;
  const tandem_reaction* reaction_ = nullptr;
  int reacting_ = 0;  ///< its states
  std::vector<std::unique_ptr<LoopSolver>> loops_;
};

}  // namespace tandem::engine
