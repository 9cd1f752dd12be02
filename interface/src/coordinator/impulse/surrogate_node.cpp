// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "surrogate.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

/// By so much of itself the slow side's answer to a force may differ from what A gives.
constexpr double largest_reaction_error = 1e-3;
/// Beyond it a slow side is something else than a mass on a spring.
constexpr double largest_spring_error = 5e-3;
/// By so much of itself A may change in a step otherwise than by the mean of its rates.
constexpr double largest_change = 0.01;

}  // namespace

/// The slow side has its spring at the mean position of its own rule, y_m = (y + y_e) / 2 - a H^2 / 12 with y_e where it
/// will come to; what that is off goes into its input. The trapezoidal rule has no such term: there a is the
/// acceleration without A F, so that its own error on the smooth motion is made up for.
void Surrogate::pass_node(const OwnStep& s) {
  for (std::size_t k = 0; k < size(); ++k) {
    const ForceIntegrals of =
        links_[k].cut_at_node(s.length, s.end - slow_.end(), forces_[0][k], forces_[2][k], slow_.length());
    stages_[0][k] = links_[k].pass(of, slow_.length(), of_.slow_step);
    positions_[k] = links_[k].mean_position() - begin_position_[k],
    velocities_[k] = links_[k].mean_velocity();
  }
  take_spring(stages_[0], positions_, velocities_, net_);
  const double middle = slow_.length() / 2.0;
  accelerance_.react(net_, middle, stages_[1]), accelerance_.react(stages_[0], middle, stages_[2]);
  for (std::size_t k = 0; k < size(); ++k) {
    SurrogateLink& link = links_[k];
    link.foresee(stages_[1][k], slow_.length());
    const double a = link.middle(slow_.length()) + stages_[1][k] - (of_.trapezoidal ? stages_[2][k] : 0.0);
    positions_[k] -= link.foreseen_mean(a, slow_.length()) - begin_position_[k],
        velocities_[k] -= link.foreseen_speed(slow_.length());
  }
  take_spring(stages_[0], positions_, velocities_, stages_[3]);
  for (std::size_t k = 0; k < size(); ++k) links_[k].set_mean_force(stages_[3][k]);
  passed_ = true;
}

void Surrogate::take_node(double t, std::span<const Signal> u) {
  const bool jumps = of_.slow_step < of_.fast_period;
  slow_.require_slow_side_at(slow_.end(), u[size()]);
  const double node = u[size()].segments().back().origin;
  varies() ? read_accelerance(node, u) : check_reaction(u, node);
  const Accelerance& next = varies() ? next_ : accelerance_;
  accelerance_.react_to(next, slow_.length(), net_, stages_[1]);
  for (std::size_t k = 0; k < size(); ++k) {
    const Signal& position = u[size() + k];
    const double rest = links_[k].rest(position.derivative(node), stages_[1][k], slow_.length());
    rest_.take(rest - links_[k].middle(slow_.length()), rest, node);
    links_[k].take(position.value(node), position.derivative(node), stages_[1][k], t - slow_.end(),
                   slow_.length(), of_.slow_step, jumps);
  }
  if (varies()) turn_to_next(t - slow_.end());
  slow_.begin_at(node);
  passed_ = false;
}

void Surrogate::read_accelerance(double node, std::span<const Signal> u) {
  for (std::size_t e = 0; e < size() * size(); ++e) {
    const Signal& one = u[2 * size() + e];
    next_.values()[e] = one.value(node), next_.rates()[e] = one.derivative(node);
    if (e % (size() + 1) == 0 && !(next_.values()[e] > 0.0))
      throw Error(ErrorCode::numerical, "impulse coupling: the accelerance of the slow side at its link " +
                                            std::to_string(e / size() + 1) + " is " +
                                            std::to_string(next_.values()[e]) +
                                            " at t = " + std::to_string(node) + " s; allowed is above 0");
    check_rate(e, node);
  }
}

/// A cubic has the mean of the rates at its ends, but for a third derivative.
void Surrogate::check_rate(std::size_t e, double node) {
  const double rate = 0.5 * (accelerance_.rates()[e] + next_.rates()[e]);
  const double off = std::abs(next_.values()[e] - accelerance_.values()[e] - slow_.length() * rate),
               own = std::abs(accelerance_.values()[e / size() * (size() + 1)]);
  if (off > changed_ * own) changed_ = off / own, changed_at_ = node;
}

/// From the node on, s before, the net force has accelerated otherwise.
void Surrogate::turn_to_next(double s) {
  for (std::size_t k = 0; k < size(); ++k)
    positions_[k] = links_[k].position() - begin_position_[k], velocities_[k] = links_[k].velocity();
  take_spring(forces_[2], positions_, velocities_, net_);
  accelerance_.react(net_, slow_.length(), stages_[0]),
      accelerance_.react(net_, slow_.length() + s, stages_[1]);
  next_.react(net_, 0.0, stages_[2]), next_.react(net_, s, stages_[3]);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].make_up(s, stages_[2][k] - stages_[0][k], stages_[3][k] - stages_[1][k]);
  std::swap(accelerance_, next_);
}

/// Before the link takes the node, and so its velocity.
void Surrogate::check_reaction(std::span<const Signal> u, double node) {
  for (std::size_t k = 0; k < size(); ++k) positions_[k] = checks_[k].change_to(links_[k].mean_force());
  accelerance_.react(positions_, 0.0, velocities_);
  for (std::size_t k = 0; k < size(); ++k) positions_[k] = links_[k].mean_force();
  accelerance_.react(positions_, 0.0, stages_[1]);
  for (std::size_t k = 0; k < size(); ++k) {
    const Signal& position = u[size() + k];
    checks_[k].take(position.derivative(node) - links_[k].rate(), slow_.length(),
                    position.second_derivative(node), stages_[1][k], velocities_[k]);
    if (const double error = checks_[k].error(); error > worst_) worst_ = error, worst_at_ = node;
  }
}

std::vector<std::string> Surrogate::remarks(double) const {
  std::vector<std::string> all;
  if (const double stated = of_.accelerance[0];
      of_.found > 0.0 && std::abs(stated / of_.found - 1.0) > largest_reaction_error)
    all.push_back("the slow side's effective mass is stated as " + std::to_string(1.0 / stated) +
                  ", and is " + std::to_string(1.0 / of_.found) +
                  " at the start, as a force of 1 finds it; allowed is the same to 0.1 %");
  if (rest_.error() > RestCheck::most)
    all.push_back(
        "the slow side's acceleration without the force bends within a step, by up to " +
        std::to_string(100.0 * rest_.error()) + " % of its largest (at t = " + std::to_string(rest_.at()) +
        " s); allowed is 20 %, so a contact, an inner mode, another force or a heavy fast side is too much "
        "for it, and the results may be off");
  if (of_.spring_error > largest_spring_error)
    all.push_back(
        "the slow side answers a force within three steps otherwise than a mass on this spring and damper, "
        "by up to " +
        std::to_string(100.0 * of_.spring_error) +
        " % of what these accelerate; allowed is 0.5 %, so it has inner modes, is far from linear, or has "
        "another "
        "stiffness, and impulse_plain or impulse_taylor fits better");
  if (changed_ > largest_change)
    all.push_back(
        "the accelerance changes otherwise than its rate says, by up to " + std::to_string(100.0 * changed_) +
        " % of it in a slow step (at t = " + std::to_string(changed_at_) +
        " s); allowed is 1 %, so it jumps, its derivative is wrong, or the slow steps are too long for it");
  else if (worst_ > largest_reaction_error)
    all.push_back("the slow side answers the force otherwise than it does, by up to " +
                  std::to_string(100.0 * worst_) + " % (at t = " + std::to_string(worst_at_) +
                  " s); allowed is 0.1 %, so its effective mass is another one, or varies, "
                  "and the results are off");
  return all;
}

}  // namespace tandem
