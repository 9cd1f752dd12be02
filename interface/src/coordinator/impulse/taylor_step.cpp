// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "taylor_surrogate.hpp"

namespace tandem {

void TaylorSurrogate::step(const OwnStep& s, std::span<const Signal> u) {
  if (passed_) take_node(s.begin, u);
  if (steps_ == 0) hear_of_start(s.begin, u);
  if (steps_ > 0 && steps_ <= of_.degree) make_up_start(s.begin, u);
  if (steps_ <= of_.degree) ++steps_;
  const double times[] = {s.begin, s.begin + s.length / 2.0, s.end};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < links(); ++k) samples_[i][k] = u[k].value(times[i]);
  for (std::size_t stage = 0; stage < 4; ++stage) {
    const std::size_t at = (stage + 1) / 2;
    begin_stage(stage, s.length, times[0] - slow_.begin());
    model_.accelerations(z_, v_, samples_[at], times[at] - slow_.begin(), stages_[stage]);
    for (std::size_t i = 0; i < size(); ++i)
      stages_[stage][i] += coordinates_[i].lacked(times[at] - slow_.begin());
  }
  for (std::size_t i = 0; i < size(); ++i) {
    TaylorCoordinate& one = coordinates_[i];
    const auto pulse = [&](std::size_t at) { return one.pulse(times[at] - slow_.begin()); };
    one.step(s.length, {stages_[0][i], stages_[1][i], stages_[2][i], stages_[3][i]},
             {pulse(0), pulse(1), pulse(2)});
  }
  for (std::size_t k = 0; k < links(); ++k)
    forces_[k].integrals.step(s.length, {samples_[0][k], samples_[1][k], samples_[2][k]});
  find_outputs(s.end);
  if (slow_.goes_on_after(s.end)) return;
  slow_.require_slow_side_at(slow_.begin(), u[links()]);
  pass_node(s);
}

/// The slow side knows all its inputs by now.
void TaylorSurrogate::hear_of_start(double t, std::span<const Signal> u) {
  Numbers rates(size());
  for (std::size_t i = 0; i < size(); ++i)
    z_[i] = u[links() + i].value(t), rates[i] = u[links() + i].derivative(t);
  begin_at(t, z_, rates);
}

/// At the end of an own step.
void TaylorSurrogate::find_outputs(double t) {
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  of_.model->motions(z_, v_, places_, velocities_);
  if (of_.tells_velocities) find_accelerations(t - slow_.begin());
}

/// The rates of velocities, s after the node, by a central difference along the motion.
void TaylorSurrogate::find_accelerations(double s) {
  model_.accelerations(z_, v_, samples_[2], s, a_);
  const double by = 0.01 * of_.own_step;
  const auto moved = [&](double ahead) {
    for (std::size_t i = 0; i < size(); ++i) {
      const TaylorCoordinate& one = coordinates_[i];
      z_[i] = one.z() + ahead * one.v();
      v_[i] = one.v() + ahead * (a_[i] + one.lacked(s) + one.pulse(s));
    }
    of_.model->motions(z_, v_, moved_places_, moved_velocities_);
  };
  moved(by);
  accelerations_ = moved_velocities_;
  moved(-by);
  for (std::size_t k = 0; k < links(); ++k)
    accelerations_[k] = (accelerations_[k] - moved_velocities_[k]) / (2.0 * by);
}

/// Where the stage of the classical Runge-Kutta method stands; s: at the begin of the step.
void TaylorSurrogate::begin_stage(std::size_t stage, double h, double s) {
  const double c = stage == 0 ? 0.0 : stage == 3 ? h : 0.5 * h, before = stage >= 2 ? 0.5 * h : 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const TaylorCoordinate& one = coordinates_[i];
    z_[i] = one.z() + (stage == 0 ? 0.0 : c * v_[i]);
    v_[i] = one.v() + (stage == 0 ? 0.0 : c * (stages_[stage - 1][i] + one.pulse(s + before)));
  }
}

/// A force that was missed accelerates by what it does where the side stands.
void TaylorSurrogate::make_up_start(double t, std::span<const Signal> u) {
  const ForceIntegrals of = missed_at_start(steps_, of_.own_step);
  Numbers missed(links());
  for (std::size_t k = 0; k < links(); ++k) {
    missed[k] = u[k].value(t) - samples_[2][k];
    forces_[k].integrals.add({of.first * missed[k], of.second * missed[k], of.third * missed[k]});
  }
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  model_.accelerations(z_, v_, missed, 0.0, a_);
  std::fill(missed.begin(), missed.end(), 0.0), model_.accelerations(z_, v_, missed, 0.0, b_);
  for (std::size_t i = 0; i < size(); ++i) {
    const double a = a_[i] - b_[i];
    coordinates_[i].make_up_start({of.first * a, of.second * a, of.third * a});
  }
}

void TaylorSurrogate::pass_node(const OwnStep& s) {
  const double over = s.end - slow_.end();
  for (std::size_t k = 0; k < links(); ++k)
    forces_[k].mean = forces_[k].window.pass(
        forces_[k].integrals.cut_at_node(s.length, over, samples_[0][k], samples_[2][k]), slow_.length(),
        of_.slow_step);
  for (std::size_t i = 0; i < size(); ++i)
    a_[i] = coordinates_[i].pass(s.length, over, stages_[0][i], stages_[3][i], slow_.length(), of_.slow_step);
  find_reaction();
  passed_ = true;
}

/// What the slow side's step is to have besides the mean force, so that it has the mean acceleration of the surrogate: by the
/// mean of what the polynomials have at both ends.
void TaylorSurrogate::find_reaction() {
  const double length = slow_.length();
  Numbers means(links());
  for (std::size_t k = 0; k < links(); ++k) means[k] = forces_[k].mean;
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].at(), v_[i] = coordinates_[i].rate();
  model_.accelerations(z_, v_, means, 0.0, b_);
  for (std::size_t i = 0; i < size(); ++i) {
    a_[i] -= 0.5 * (b_[i] + coordinates_[i].lacked(length));
    z_[i] = coordinates_[i].foreseen(), v_[i] = coordinates_[i].foreseen_rate();
  }
  model_.accelerations(z_, v_, means, length, b_);
  for (std::size_t i = 0; i < size(); ++i) a_[i] -= 0.5 * b_[i];
  model_.forces_for(z_, a_, reaction_);
}

/// What the polynomials lack at the end of the slow side's step is twice the mean acceleration that neither they nor the
/// reaction have, gm. Other inputs count there as they have become, not as they were foreseen.
void TaylorSurrogate::find_lacks(double node, const Numbers& q, const Numbers& rates, Numbers& lacks) {
  Numbers means(links());
  for (std::size_t k = 0; k < links(); ++k) means[k] = forces_[k].mean;
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].at(), v_[i] = coordinates_[i].rate();
  model_.answer(q, reaction_, a_), model_.accelerations(z_, v_, means, 0.0, b_);
  for (std::size_t i = 0; i < size(); ++i)
    lacks[i] = 2.0 * ((rates[i] - v_[i]) / slow_.length() - a_[i]) - b_[i];
  model_.see_inputs(node);
  model_.accelerations(q, rates, means, 0.0, b_);
  for (std::size_t i = 0; i < size(); ++i) lacks[i] -= b_[i] + model_.changed()[i];
}

void TaylorSurrogate::take_node(double t, std::span<const Signal> u) {
  slow_.require_slow_side_at(slow_.end(), u[links()]);
  const double node = u[links()].segments().back().origin, s = t - slow_.end();
  Numbers q(size()), rates(size()), lacks(size()), before(size());
  for (std::size_t i = 0; i < size(); ++i)
    q[i] = u[links() + i].value(node), rates[i] = u[links() + i].derivative(node);
  find_lacks(node, q, rates, lacks);
  for (std::size_t i = 0; i < size(); ++i)
    rest_.take(lacks[i], (rates[i] - coordinates_[i].rate()) / slow_.length(), node);
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  model_.accelerations(z_, v_, samples_[2], slow_.length() + s, before);
  for (std::size_t i = 0; i < size(); ++i) {
    before[i] += coordinates_[i].lacked(slow_.length() + s);
    coordinates_[i].take(q[i], rates[i], lacks[i], s, slow_.length(), of_.slow_step, jumps());
  }
  model_.expand(node, q, rates);
  slow_.begin_at(node);
  turn_to_next(s, before);
  passed_ = false;
}

std::vector<std::string> TaylorSurrogate::remarks(double) const {
  if (!(rest_.error() > RestCheck::most)) return {};
  return {
      "the slow side's equations bend within a step beyond their Taylor polynomial, by up to " +
      std::to_string(100.0 * rest_.error()) +
      " % of its largest acceleration (at t = " + std::to_string(rest_.at()) +
      " s); allowed is 20 %, so its steps are too long for a contact, another force or the mean force of the "
      "fast motion, and the results may be off"};
}

/// From the node on, s before, the polynomials are others.
void TaylorSurrogate::turn_to_next(double s, const Numbers& before) {
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  model_.accelerations(z_, v_, samples_[2], s, a_);
  for (std::size_t i = 0; i < size(); ++i)
    coordinates_[i].make_up(s, a_[i] + coordinates_[i].lacked(s) - before[i]);
}

}  // namespace tandem
