// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "step_integrals.hpp"
#include "tandem/coordinator/impulse/defect_pulse.hpp"

namespace tandem {

/// One link of an impulse surrogate. Times s are since the slow side's last node [s]; what A makes of the forces of all
/// links together is told from outside.
class SurrogateLink {
 public:
  /// g: the slow side's acceleration there without these forces.
  SurrogateLink(ForceWindow window, double position, double velocity, double g);

  /// The smooth rest of the acceleration, and what is put in of the last defect.
  double acceleration(double s) const { return g_ + g_rate_ * s + pulse_.acceleration(s); }
  /// A step of the classical Runge-Kutta method: the force at its begin, middle and end, and the acceleration at its
  /// four stages.
  void step(double h, const double (&force)[3], const double (&acceleration)[4]);
  /// What it integrates, where the fast side does that: integrals of the force, position, velocity, integral of position.
  static constexpr std::size_t states = 6;
  enum State : std::size_t { force_first, force_second, force_third, at, rate_of, position_sum };
  void get_states(double* z) const;
  /// After an own step of the fast side.
  void go_to(const double* z);
  /// What is put in of the last defect: its acceleration, c0 + c1 s + c2 s^2 + c3 s^3.
  std::array<double, 4> pulse() const { return pulse_.polynomial(); }
  double smooth() const { return g_; }            ///< acceleration at the node
  double smooth_rate() const { return g_rate_; }  ///< and its change
  /// After one of the first four steps: the polynomial of the force that it went by missed the force at its end by so
  /// much; and A times that.
  void make_up_start(int steps, double h, double missed, double reaction);
  /// The slow side's node lies in the last step, h long, s before its end: the integrals of the force up to there, over
  /// the slow side's step, `length` long. From here on they count from that node.
  ForceIntegrals cut_at_node(double h, double s, double force_before, double force_now, double length);

  /// After that: the means of position and velocity over the same step.
  double mean_position() const { return mean_position_; }
  double mean_velocity() const { return mean_velocity_; }

  double position() const { return y_; }
  double rate() const { return rate_; }  ///< of the slow side at its last node
  double velocity() const { return v_; }
  double mean_force() const { return mean_force_; }
  void set_mean_force(double force) { mean_force_ = force; }

  /// At the end of the slow side's step: the mean of the link's force.
  double pass(const ForceIntegrals& of, double length, double next) { return window_.pass(of, length, next); }
  /// What the slow side will come to by its step, `length` long, with A times the mean of the net forces.
  void foresee(double reaction, double length);
  /// The mean position over that step, with this acceleration.
  double foreseen_mean(double acceleration, double length) const;
  /// The smooth acceleration in the middle of that step.
  double middle(double length) const { return g_ + g_rate_ * length / 2.0; }
  double foreseen_speed(double length) const { return (foreseen_ - at_) / length; }
  /// What the slow side has accelerated in that step besides A times the mean of the net forces, with its velocity there.
  double rest(double velocity, double reaction, double length) const {
    return (velocity - rate_) / length - reaction;
  }
  /// What it came to, s after that; next: the length of its coming step; jumps: a defect is put in at once.
  void take(double position, double velocity, double reaction, double s, double length, double next,
            bool jumps);

  /// The acceleration since the node, s [s] ago, was off by so much then, and is now.
  void make_up(double s, double then, double now);

  /// What it goes on from at a node that has not been heard of, but for the lengths of steps.
  std::vector<double*> numbers();
  /// Makes the start such a node: in a step before it, `length` long, it accelerated as it does now.
  void begin_at_node(double acceleration, double length);
  /// Before its numbers are put: steps were `length` long.
  void go_on(double length) { length_ = length, pulse_ = DefectPulse(0.0, 0.0, length); }

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  std::vector<double*> own_numbers();
  void follow(double g_mean, double s, double length);

  StepIntegrals forces_;
  double y_, v_;             ///< of the surrogate
  double at_, rate_;         ///< of the slow side at its last node
  double g_, g_rate_ = 0.0;  ///< there, and its change [1/s]
  double g_mean_ = 0.0;      ///< over the step before
  double foreseen_ = 0.0, foreseen_rate_ = 0.0, mean_force_ = 0.0;
  double sum_position_ = 0.0, before_sum_ = 0.0;          ///< integral of y_, as of the force
  double before_position_ = 0.0, before_velocity_ = 0.0;  ///< at the begin of the last step
  double from_position_;                                  ///< y_ at the slow side's last node
  double mean_position_ = 0.0, mean_velocity_ = 0.0;
  double length_ = 0.0;  ///< of the step before; 0: it is the first
  DefectPulse pulse_;
  ForceWindow window_;
};

}  // namespace tandem
