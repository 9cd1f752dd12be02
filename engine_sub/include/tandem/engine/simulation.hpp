// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tandem/engine/integrators/integrator.hpp"

namespace tandem::engine {

class Past;

struct SimulationSettings {
  /// Times within one own step at which something happens, an event that follows from another at the same
  /// time counted for itself; with more it chatters, and that is an error.
  int most_events = 1000;
  /// Takes what is told once and does not end a run: a signal that has left its limits; by make_subsystem()
  /// also a block that was left out. Null: nobody.
  std::function<void(const std::string&)> tell = {};
};

/// A compiled diagram that moves: steps between instants, and what happens at events. At an event all its
/// updates take the values from before it; then other signs that have changed by that have their events, in
/// the order of the diagram's blocks.
class Simulation {
 public:
  /// `program` and `inputs` (null: the program has none) must outlive it.
  Simulation(const Program& program, InputSource* inputs, std::unique_ptr<Integrator> integrator,
             const SimulationSettings& settings = {});

  /// with_events: also those that are due at t.
  void start(double t, bool with_events = true);
  /// One own step: to t_end.
  void run(double t_end);
  /// The same, or what is left of it; but it returns where events make an output jump. True: that is so, at
  /// time(), which may be t_end.
  bool run_to_jump(double t_end);
  /// Where run_to_jump() has returned true: the outputs just before, with their derivatives (Program::row).
  const std::vector<double>& left() const { return left_; }
  /// Inputs have jumped at time(). Whether outputs have with them.
  bool jump();
  /// Of a sampled program (Program::sampled): what happens at its instant t; of any, what is due at t.
  void act(double t);

  // Where somebody else integrates (ExchangedDiagram): start() and act() are those from above.
  System& system() { return system_; }
  /// Own steps are so long [s], beside which a step after a bounce is short. After start().
  void expect_steps(double h) { slot(system_.program().longest_step) = h; }
  /// The integrator has come to t, and system() is as there. Throws as step().
  void arrive(double t);
  /// Of what is due and known beforehand the time after time(); infinity: there is none.
  double next_event();

  /// The first instant of a periodic event that has not been yet; one has to be there.
  double next_periodic() const;
  /// One own step: to t_end, or, with an integrator that chooses its steps, to the end of one of them.
  /// Returns the time. Both throw Error(numerical) with the time and a block's name: a signal that is not
  /// finite, chattering, an integrator that can't go on.
  double step(double t_end);

  double time() const { return time_; }
  Statistics statistics() const { return integrator_->statistics(); }
  double output(int k) const {
    return system_.image()[static_cast<std::size_t>(system_.program().outputs[k])];
  }

  /// All that a run goes by from here on, and back; the integrator starts anew at both, as a multistep method
  /// has a past that is not in it.
  const std::vector<double>& keep();
  const std::vector<double>& signals() const { return system_.image(); }
  void restore(double t, std::span<const double> state);
  /// Its states where it stands; all signals follow, and the integrator starts anew.
  void put_states(std::span<const double> x);
  /// System::react(), for steps from here on. Precondition: takes_reaction().
  void react(const tandem_reaction* reaction);
  bool takes_reaction() const { return integrator_->takes_reaction() && system_.program().room() > 0; }
  std::span<const double> reaction_states() const { return system_.reaction_states(); }
  /// Whether keep() leaves what follows as it would be without it.
  bool keeps_exactly() const { return integrator_->goes_by_image(); }

 private:
  double sign_at_start(const Crossing& crossing) const;
  void remember();
  void settle();
  void begin_step();
  double advance(double t_end);
  double due(const Periodic& periodic) const;
  double& slot(int which) { return system_.image()[static_cast<std::size_t>(which)]; }
  void watch_jumps();
  void note_left();
  /// What makes outputs jump. Inputs may have jumped in a way that is no jump of theirs, as they are
  /// extrapolated anew. They may then turn a switch that should have turned between. That switch is late,
  /// which is nothing of the outputs' own unless they are held.
  enum class By { events, inputs, break_of_inputs };
  By cause();
  bool has_jumped(By by);
  void note_sizes();
  double short_step() const;
  bool is_beyond(const Crossing& crossing) const;
  double next_turn() const;
  void look_at_turns();
  [[noreturn]] void refuse_endless(const Crossing& crossing, double t) const;
  double rounding() const;
  bool bends() const;
  double next_instant(double t_end);
  double next_jump(const DataJumps& data) const;
  bool pass_data_jumps();
  void fire_known();
  void fire_crossings();
  void apply(const std::vector<Update>& updates);
  void happened(const std::string& block);
  void look_at_bounds();
  void leave(const Crossing& crossing);
  void begin_course();
  Past past(const Delay& delay);
  void record(int level);
  void note_jumps();
  void turn_delays();
  bool is_finite() const;
  void refuse_not_finite() const;
  void refuse_outside() const;

  System system_;
  std::unique_ptr<Integrator> integrator_;
  SimulationSettings settings_;
  double start_ = 0.0, time_ = 0.0;
  double call_begin_ = 0.0;
  bool has_turns_ = false;      ///< there are events that put states
  bool watches_jumps_ = false;  ///< of outputs
  bool stops_ = false;          ///< where they are
  bool jumped_ = false;
  double smallest_jump_ = 0.0;  ///< relative to the output's size
  std::vector<double> left_;    ///< a row, of before
  bool begun_ = false;          ///< a step has been asked for since the start
  std::vector<bool> was_told_;  ///< by bound
  std::vector<double> before_;
  std::vector<const Delay*> delays_;
  bool follows_courses_ = false;  ///< an adaptive integrator stops where inputs jump or bend
  double course_end_ = 0.0;
  bool has_instants_ = false;  ///< at which steps end, beside those of own steps
};

}  // namespace tandem::engine
