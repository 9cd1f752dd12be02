// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

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
  void end_at(double t_stop) { t_stop_ = t_stop; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  using Numbers = std::vector<double>;
  struct Force {
    StepIntegrals integrals;
    ForceWindow window;
    double mean = 0.0;
  };

  std::size_t links() const { return of_.links.size(); }
  std::size_t size() const { return of_.velocities.size(); }
  double length() const { return end_ - begin_; }
  bool jumps() const { return of_.slow_step < of_.fast_period; }
  void begin_slow_step(double t);
  void check_slow_side(double t, const Signal& coordinate) const;
  void begin_stage(std::size_t stage, double h, double s);
  void find_outputs(double t);
  void make_up_start(double t, std::span<const Signal> u);
  void pass_node(const OwnStep& s);
  void find_reaction();
  void take_node(double t, std::span<const Signal> u);
  void turn_to_next(double s, const Numbers& before);

  TaylorCoupling of_;
  TaylorModel model_;
  double t_stop_ = 0.0;
  TimeTolerance tolerance_;
  double begin_ = 0.0, end_ = 0.0;  ///< of the slow side's step [s]
  bool passed_ = false;             ///< its end, and the slow side has not been heard since
  int steps_ = 0;                   ///< own ones so far, up to degree + 1
  std::vector<TaylorCoordinate> coordinates_;
  std::vector<Force> forces_;
  Numbers reaction_;                ///< generalised forces on the slow side
  std::array<Numbers, 3> samples_;  ///< of the forces, at begin, middle and end of a step
  std::array<Numbers, 4> stages_;   ///< accelerations at the stages of a step
  Numbers places_, velocities_,
      accelerations_;      ///< of the links' displacements, at the end of the last own step
  Numbers z_, v_, a_, b_;  ///< scratch: n numbers
};

}  // namespace tandem
