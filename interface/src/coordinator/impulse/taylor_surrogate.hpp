// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

#include "rest_check.hpp"
#include "slow_step.hpp"
#include "step_integrals.hpp"
#include "tandem/coordinator/impulse/taylor_surrogate.hpp"
#include "tandem/fixed_step.hpp"
#include "taylor_coordinate.hpp"
#include "taylor_model.hpp"

namespace tandem {

/// The model of taylor_surrogate().
class TaylorSurrogate {
 public:
  explicit TaylorSurrogate(TaylorCoupling coupling);

  SubsystemInfo info() const;
  double own_step() const { return of_.own_step; }
  void end_at(double t_stop) { slow_.end_at(t_stop); }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  std::vector<std::string> remarks(double t_stop) const;
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  using Numbers = std::vector<double>;
  void hear_of_start(double t, std::span<const Signal> u);
  void begin_at(double t, const Numbers& z, const Numbers& rates);
  struct Force {
    StepIntegrals integrals;
    ForceWindow window;
    double mean = 0.0;
  };

  std::size_t links() const { return of_.links.size(); }
  std::size_t size() const { return of_.velocities.size(); }
  bool jumps() const { return of_.slow_step < of_.fast_period; }
  void begin_stage(std::size_t stage, double h, double s);
  void find_outputs(double t);
  void find_accelerations(double s);
  void make_up_start(double t, std::span<const Signal> u);
  void pass_node(const OwnStep& s);
  void find_reaction();
  void find_lacks(double node, const Numbers& q, const Numbers& rates, Numbers& lacks);
  void take_node(double t, std::span<const Signal> u);
  void turn_to_next(double s, const Numbers& before);

  TaylorCoupling of_;
  TaylorModel model_;
  SlowStep slow_;
  bool passed_ = false;  ///< the end of the slow side's step, and that has not been heard since
  int steps_ = 0;        ///< own ones so far, up to degree + 1
  std::vector<TaylorCoordinate> coordinates_;
  std::vector<Force> forces_;
  RestCheck rest_;
  Numbers reaction_;                ///< generalised forces on the slow side
  std::array<Numbers, 3> samples_;  ///< of the forces, at begin, middle and end of a step
  std::array<Numbers, 4> stages_;   ///< accelerations at the stages of a step
  Numbers places_, velocities_,
      accelerations_;  ///< of the links' displacements, at the end of the last own step
  Numbers moved_places_, moved_velocities_;
  Numbers z_, v_, a_, b_;  ///< scratch: n numbers
};

}  // namespace tandem
