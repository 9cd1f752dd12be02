// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tandem/engine/simulation.hpp"
#include "tandem/error.hpp"

// Outputs and data that jump, and instants of sampled programs.
namespace tandem::engine {
namespace {

/// Both sides of a kink differ by as much as an event is located late, which is some 1e-12 of a step, or as
/// much as loops are solved for.
constexpr double location_errors = 1e-9, loop_errors = 10.0;

}  // namespace

void Simulation::watch_jumps() {
  const Program& program = system_.program();
  watches_jumps_ = program.jumps() || !program.feedthrough.empty();
  left_.resize(program.outputs.size() + program.output_rates.size());
  smallest_jump_ = location_errors;
  for (const Loop& loop : program.loops)
    smallest_jump_ = std::max(smallest_jump_, loop_errors * loop.settings.tolerance);
}

bool Simulation::run_to_jump(double t_end) {
  const Program& program = system_.program();
  jumped_ = false;
  if (slot(program.step_begun) == 0.0) {
    note_left();
    begin_step();
    if (slot(program.events) > 0.0) jumped_ = has_jumped(By::events);
  }
  stops_ = true;
  while (time_ < t_end && !jumped_) advance(t_end);
  stops_ = false;
  slot(program.step_begun) = time_ < t_end - rounding() ? 1.0 : 0.0;
  return jumped_;
}

void Simulation::note_left() { system_.program().row(system_.image().data(), left_.data()); }

/// The largest magnitudes of outputs so far, beside which a jump is one.
void Simulation::note_sizes() {
  const auto& outputs = system_.program().outputs;
  double* size = &slot(system_.program().sizes);
  for (const int output : outputs) *size = std::max(*size, std::abs(slot(output))), ++size;
}

/// Of an event at time().
Simulation::By Simulation::cause() {
  const bool at_begin = time_ <= call_begin_ + 2.0 * rounding();
  return at_begin && !system_.inputs_jump_at(call_begin_) ? By::break_of_inputs : By::events;
}

/// Since note_left(). Of outputs that have not, also the row from before gives what they are now.
bool Simulation::has_jumped(By by) {
  const Program& program = system_.program();
  bool any = false;
  for (std::size_t k = 0; k < program.outputs.size(); ++k) {
    const Course& course = program.courses[k];
    const double now = slot(program.outputs[k]), before = left_[k],
                 size = std::max(slot(program.sizes + static_cast<int>(k)), std::abs(now));
    const bool differs = course.held ? now != before : std::abs(now - before) > smallest_jump_ * size;
    if (!differs || !(course.jumps || by == By::inputs))
      left_[k] = now;
    else
      any = any || course.held || by != By::break_of_inputs;
  }
  return any;
}

bool Simulation::jump() {
  if (!watches_jumps_) return false;
  note_left();
  system_.evaluate_again(time_);
  if (system_.changed() >= 0) fire_crossings();
  return has_jumped(By::inputs);
}

/// Of data, after the run that they are in.
double Simulation::next_jump(const DataJumps& d) const {
  const auto jumps = system_.program().data[static_cast<std::size_t>(d.data)].jumps();
  const auto run = static_cast<std::size_t>(system_.image()[static_cast<std::size_t>(d.run)]);
  return run < jumps.size() ? jumps[run] : std::numeric_limits<double>::infinity();
}

/// Data go on to what holds from now on. Whether there was a jump.
bool Simulation::pass_data_jumps() {
  bool any = false;
  for (const DataJumps& d : system_.program().data_jumps)
    for (; next_jump(d) <= time_ + rounding(); any = true) slot(d.run) += 1.0;
  return any;
}

void Simulation::act(double t) {
  time_ = t;
  slot(system_.program().events) = 0.0;
  pass_data_jumps();
  system_.evaluate(t);
  if (!std::exchange(begun_, true)) look_at_bounds();
  if (system_.changed() >= 0) fire_crossings();
  fire_known();
  refuse_not_finite();
  if (!system_.program().ranges.empty()) refuse_outside();
  if (has_turns_) look_at_turns();
}

double Simulation::next_periodic() const {
  double next = std::numeric_limits<double>::infinity();
  for (const Periodic& p : system_.program().periodics) next = std::min(next, due(p));
  return next;
}

}  // namespace tandem::engine
