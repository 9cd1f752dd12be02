// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tandem/error.hpp"
#include "taylor_surrogate.hpp"

namespace tandem {

void TaylorSurrogate::step(const OwnStep& s, std::span<const Signal> u) {
  if (passed_) take_node(s.begin, u);
  if (steps_ > 0 && steps_ <= of_.degree) make_up_start(s.begin, u);
  if (steps_ <= of_.degree) ++steps_;
  const double times[] = {s.begin, s.begin + s.length / 2.0, s.end};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < links(); ++k) samples_[i][k] = u[k].value(times[i]);
  for (std::size_t stage = 0; stage < 4; ++stage) {
    const std::size_t at = (stage + 1) / 2;
    begin_stage(stage, s.length, times[0] - begin_);
    model_.accelerations(z_, v_, samples_[at], stages_[stage]);
    for (std::size_t i = 0; i < size(); ++i)
      stages_[stage][i] += coordinates_[i].lacked(times[at] - begin_, length());
  }
  for (std::size_t i = 0; i < size(); ++i) {
    TaylorCoordinate& one = coordinates_[i];
    const auto pulse = [&](std::size_t at) { return one.pulse(times[at] - begin_); };
    one.step(s.length, {stages_[0][i], stages_[1][i], stages_[2][i], stages_[3][i]},
             {pulse(0), pulse(1), pulse(2)});
  }
  for (std::size_t k = 0; k < links(); ++k)
    forces_[k].integrals.step(s.length, {samples_[0][k], samples_[1][k], samples_[2][k]});
  find_outputs(s.end);
  if (tolerance_.before(s.end, end_)) return;
  check_slow_side(begin_, u[links()]);
  pass_node(s);
}

/// At the end of an own step; the rate of velocities by a central difference along the motion.
void TaylorSurrogate::find_outputs(double t) {
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  of_.model->motions(z_, v_, places_, velocities_);
  if (!of_.tells_velocities) return;
  model_.accelerations(z_, v_, samples_[2], a_);
  Numbers places(links()), rates(links());
  const double by = 0.01 * of_.own_step, s = t - begin_;
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < size(); ++i) {
      const TaylorCoordinate& one = coordinates_[i];
      z_[i] = one.z() + sign * by * one.v();
      v_[i] = one.v() + sign * by * (a_[i] + one.lacked(s, length()) + one.pulse(s));
    }
    of_.model->motions(z_, v_, places, rates);
    for (std::size_t k = 0; k < links(); ++k)
      accelerations_[k] = (sign > 0.0 ? rates[k] : accelerations_[k] - rates[k]);
  }
  for (double& a : accelerations_) a /= 2.0 * by;
}

/// Where the stage of the classical Runge-Kutta method stands; s: at the begin of the step.
void TaylorSurrogate::begin_stage(std::size_t stage, double h, double s) {
  const double c = stage == 0 ? 0.0 : stage == 3 ? h : 0.5 * h, before = stage == 3 ? 0.5 * h : 0.0;
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
  model_.accelerations(z_, v_, missed, a_);
  std::fill(missed.begin(), missed.end(), 0.0), model_.accelerations(z_, v_, missed, b_);
  for (std::size_t i = 0; i < size(); ++i) {
    const double a = a_[i] - b_[i];
    coordinates_[i].make_up_start({of.first * a, of.second * a, of.third * a});
  }
}

void TaylorSurrogate::pass_node(const OwnStep& s) {
  const double over = s.end - end_;
  for (std::size_t k = 0; k < links(); ++k)
    forces_[k].mean = forces_[k].window.pass(
        forces_[k].integrals.cut_at_node(s.length, over, samples_[0][k], samples_[2][k]), length(),
        of_.slow_step);
  for (std::size_t i = 0; i < size(); ++i)
    a_[i] = coordinates_[i].pass(s.length, over, stages_[0][i], stages_[3][i], length(), of_.slow_step);
  find_reaction();
  passed_ = true;
}

/// What the slow side's step is to have besides the mean force, so that it has the mean acceleration of the surrogate: by the
/// mean of what the polynomials have at both ends.
void TaylorSurrogate::find_reaction() {
  Numbers means(links());
  for (std::size_t k = 0; k < links(); ++k) means[k] = forces_[k].mean;
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].at(), v_[i] = coordinates_[i].rate();
  model_.accelerations(z_, v_, means, b_);
  for (std::size_t i = 0; i < size(); ++i)
    a_[i] -= 0.5 * (b_[i] + coordinates_[i].lacks()), z_[i] = coordinates_[i].foreseen(),
                                                      v_[i] = coordinates_[i].foreseen_rate();
  model_.accelerations(z_, v_, means, b_);
  for (std::size_t i = 0; i < size(); ++i) a_[i] -= 0.5 * b_[i];
  model_.forces_for(z_, a_, reaction_);
}

void TaylorSurrogate::check_slow_side(double t, const Signal& coordinate) const {
  const double at = coordinate.segments().back().origin;
  if (!tolerance_.before(at, t) && !tolerance_.before(t, at)) return;
  throw Error(ErrorCode::not_supported,
              "impulse coupling: the slow side stands at " + std::to_string(at) +
                  " s where it is to stand at " + std::to_string(t) +
                  " s; allowed is an order in which the surrogate and the fast sides lead it");
}

/// gm, the mean acceleration that neither the polynomials nor the reaction have, is half of what they lack at the end of the
/// step.
void TaylorSurrogate::take_node(double t, std::span<const Signal> u) {
  check_slow_side(end_, u[links()]);
  const double node = u[links()].segments().back().origin, s = t - end_;
  Numbers means(links()), q(size()), rates(size()), lacks(size()), before(size());
  for (std::size_t k = 0; k < links(); ++k) means[k] = forces_[k].mean;
  for (std::size_t i = 0; i < size(); ++i)
    q[i] = u[links() + i].value(node), rates[i] = u[links() + i].derivative(node),
    z_[i] = coordinates_[i].at(), v_[i] = coordinates_[i].rate();
  model_.answer(q, reaction_, a_), model_.accelerations(z_, v_, means, b_);
  for (std::size_t i = 0; i < size(); ++i) lacks[i] = 2.0 * ((rates[i] - v_[i]) / length() - a_[i]) - b_[i];
  model_.accelerations(q, rates, means, b_);
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  model_.accelerations(z_, v_, samples_[2], before);
  for (std::size_t i = 0; i < size(); ++i) {
    before[i] += coordinates_[i].lacked(length() + s, length());
    coordinates_[i].take(q[i], rates[i], lacks[i] - b_[i], s, length(), of_.slow_step, jumps());
  }
  model_.expand(node, q, rates);
  begin_slow_step(node);
  turn_to_next(s, before);
  passed_ = false;
}

/// From the node on, s before, the polynomials are others.
void TaylorSurrogate::turn_to_next(double s, const Numbers& before) {
  for (std::size_t i = 0; i < size(); ++i) z_[i] = coordinates_[i].z(), v_[i] = coordinates_[i].v();
  model_.accelerations(z_, v_, samples_[2], a_);
  for (std::size_t i = 0; i < size(); ++i)
    coordinates_[i].make_up(s, a_[i] + coordinates_[i].lacked(s, length()) - before[i]);
}

}  // namespace tandem
