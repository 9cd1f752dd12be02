// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::mbs {

/// A model in lengths: x = S q and P Phi by the scales of its structure, so M becomes S^-1 M S^-1, Q S^-1 Q,
/// Phi_q P Phi_q S^-1, and lambda P^-1 lambda; energies stay. Its structure has no scales. The same model
/// where it has no scales.
class Scaled final : public Model {
 public:
  explicit Scaled(Model& of);  ///< which must outlive it

  const Structure& structure() const override { return structure_; }
  void at_time(double t) override { model_.at_time(t); }
  void constraints(const double* x, double* phi, double* jacobian) const override;
  void constraint_rates(const double* x, double* phi_t) const override;
  void constraint_accelerations(const double* x, const double* v, double* gamma) const override;
  Off off(int constraint, const double* x, double phi) const override;
  void forces(const double* x, const double* v, double* force) const override;
  void force_derivatives(const double* x, const double* v, double* k, double* c) const override;
  double energy(const double* x, const double* v) const override;

  /// States there and back; vectors may be empty.
  void scale(State& s) const;
  void restore(State& s) const;
  double coordinate_scale(int coordinate) const { return s_[coordinate]; }
  /// Phi or a derivative of it, of the model itself.
  Eigen::VectorXd restored_constraints(const Eigen::VectorXd& phi) const { return phi.cwiseQuotient(p_); }

 private:
  const double* restored(const double* x, Eigen::VectorXd& into) const;
  void divide(const Pattern& pattern, double* values) const;
  void multiply_constraints(double* phi) const;

  Model& model_;
  Structure structure_;
  Eigen::VectorXd s_, p_;
  mutable Eigen::VectorXd q_, v_;
};

/// Steps in lengths of a state that stays as it is.
class ScaledStepper final : public Stepper {
 public:
  template <class Make>
  ScaledStepper(Model& model, const Make& make) : model_(model), stepper_(make(model_)) {}

  void start(State& s) override;
  int step(State& s, double h, double t_end) override;
  void refresh(State& s) override;
  TangentFactors tangent_factors(double h) const override { return stepper_->tangent_factors(h); }
  void remember(std::vector<double>& to) const override { stepper_->remember(to); }
  void recall(std::span<const double> memory) override { stepper_->recall(memory); }

 private:
  Scaled model_;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace tandem::mbs
