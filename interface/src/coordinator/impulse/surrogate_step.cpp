// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "surrogate.hpp"

namespace tandem {

void Surrogate::step(const OwnStep& s, std::span<const Signal> u) {
  if (passed_) take_node(s.begin, u);
  if (steps_ == 0) hear_of_start(u);
  if (steps_ > 0 && steps_ <= of_.degree) make_up_start(s.begin, u);
  if (steps_ <= of_.degree) ++steps_;
  const double times[] = {s.begin, s.begin + s.length / 2.0, s.end};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < size(); ++k) forces_[i][k] = u[k].value(times[i]);
  for (std::size_t stage = 0; stage < 4; ++stage) accelerate(stage, s.length, times);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].step(s.length, {forces_[0][k], forces_[1][k], forces_[2][k]},
                   {stages_[0][k], stages_[1][k], stages_[2][k], stages_[3][k]});
  end_step(s, u);
}

void Surrogate::end_step(const OwnStep& s, std::span<const Signal> u) {
  if (of_.tells_velocities) find_accelerations(s.end);
  if (slow_.goes_on_after(s.end)) return;
  slow_.require_slow_side_at(slow_.begin(), u[size()]);
  pass_node(s);
}

/// Of the stage of the classical Runge-Kutta method, from the one before.
void Surrogate::accelerate(std::size_t stage, double h, const double (&times)[3]) {
  const std::size_t at = (stage + 1) / 2;
  const double c = stage == 0 ? 0.0 : stage == 3 ? h : 0.5 * h;
  for (std::size_t k = 0; k < size(); ++k) {
    positions_[k] = links_[k].position() - begin_position_[k] + (stage == 0 ? 0.0 : c * velocities_[k]);
    velocities_[k] = links_[k].velocity() + (stage == 0 ? 0.0 : c * stages_[stage - 1][k]);
  }
  take_spring(forces_[at], positions_, velocities_, net_);
  accelerance_.react(net_, times[at] - slow_.begin(), stages_[stage]);
  for (std::size_t k = 0; k < size(); ++k)
    stages_[stage][k] += links_[k].acceleration(times[at] - slow_.begin());
}

/// The forces without those of the slow side's own springs and dampers; y from the start.
void Surrogate::take_spring(const Forces& forces, const Forces& y, const Forces& v, Forces& net) const {
  net = forces;
  if (of_.stiffness.empty()) return;
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < size(); ++k)
      net[i] -= of_.stiffness[i * size() + k] * y[k] + of_.damping[i * size() + k] * v[k];
}

/// At the end of an own step.
void Surrogate::find_accelerations(double t) {
  for (std::size_t k = 0; k < size(); ++k)
    positions_[k] = links_[k].position() - begin_position_[k], velocities_[k] = links_[k].velocity();
  take_spring(forces_[2], positions_, velocities_, net_);
  accelerance_.react(net_, t - slow_.begin(), accelerations_);
  for (std::size_t k = 0; k < size(); ++k) accelerations_[k] += links_[k].acceleration(t - slow_.begin());
}

void Surrogate::make_up_start(double t, std::span<const Signal> u) {
  for (std::size_t k = 0; k < size(); ++k) net_[k] = u[k].value(t) - forces_[2][k];
  accelerance_.react(net_, t - slow_.begin(), stages_[0]);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].make_up_start(steps_, of_.own_step, net_[k], stages_[0][k]);
}

}  // namespace tandem
