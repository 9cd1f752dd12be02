// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "tandem/mbs/mechanism/description.hpp"
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

class ConstraintSet;

/// A mechanism in natural coordinates: those of its points and vectors, the variable ones first. The general
/// Model: constraints are kept by kind, and each kind is evaluated in one loop.
class Mechanism final : public Model {
 public:
  /// Throws Error for what can't be assembled, with names, values found and values allowed.
  explicit Mechanism(const Description& description);
  ~Mechanism() override;

  const Structure& structure() const override { return structure_; }
  void at_time(double) override {}
  void constraints(const double* q, double* phi, double* jacobian) const override;
  void constraint_rates(const double* q, double* phi_t) const override;
  void constraint_accelerations(const double* q, const double* v, double* gamma) const override;
  void forces(const double* q, const double* v, double* force) const override;
  void force_derivatives(const double*, const double*, double*, double*) const override {}
  double energy(const double* q, const double* v) const override;

  /// As described: positions and velocities at the start, nothing else yet.
  State described_state() const;
  /// First coordinate of a point or vector of the description; the others follow it.
  int coordinate(int entity) const { return first_[entity]; }

 private:
  void number_coordinates(const Description& description);
  void add_masses(const Description& description);
  void add_constraints(const Description& description);

  Structure structure_;
  std::vector<int> first_;  ///< by entity
  State start_;
  std::vector<std::unique_ptr<ConstraintSet>> sets_;
  Eigen::VectorXd weight_;
};

}  // namespace tandem::mbs
