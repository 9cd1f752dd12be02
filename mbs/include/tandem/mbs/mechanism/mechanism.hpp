// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "tandem/mbs/mechanism/numbering.hpp"
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

class ConstraintSet;
class ForceSet;

/// Gives a mechanism the inputs that come from outside.
class InputSource {
 public:
  virtual ~InputSource() = default;
  /// values: one for each input of the description; those with a function of time are not to be touched.
  virtual void at(double t, std::span<InputValue> values) = 0;
};

/// A mechanism in natural coordinates: those of its points and vectors, the variable ones first, with the
/// relative coordinates between. The general Model: constraints and forces are kept by kind, and each kind is
/// evaluated in one loop.
class Mechanism final : public Model {
 public:
  /// Throws Error for what can't be assembled, with names, values found and values allowed.
  explicit Mechanism(Description description);
  ~Mechanism() override;
  Mechanism(const Mechanism&) = delete;
  Mechanism& operator=(const Mechanism&) = delete;

  const Structure& structure() const override { return structure_; }
  void at_time(double t) override;
  void constraints(const double* q, double* phi, double* jacobian) const override;
  void constraint_rates(const double* q, double* phi_t) const override;
  void constraint_accelerations(const double* q, const double* v, double* gamma) const override;
  Off off(int constraint, const double* q, double phi) const override;
  void forces(const double* q, const double* v, double* force) const override;
  void force_derivatives(const double* q, const double* v, double* k, double* c) const override;
  double energy(const double* q, const double* v) const override { return kinetic(v) + potential(q); }

  double kinetic(const double* v) const;    ///< [J]
  double potential(const double* q) const;  ///< [J], of weight and springs

  /// Inputs without a function keep their value of the description until a source is given, which must
  /// outlive its use.
  void set_inputs(InputSource* source) { source_ = source; }
  InputSource* source() const { return source_; }  ///< none: null
  /// Inputs that say no place (no drive follows them, their unit is neither m nor rad) get the value that the
  /// description has for them, 0 where it has none, until the next at_time().
  void reset_inputs();
  /// Inputs as of the last at_time().
  std::span<const InputValue> inputs() const { return inputs_; }

  const Description& description() const { return description_; }
  /// As described: positions and velocities where the initial problems begin, nothing else yet.
  State described_state() const;
  const Numbering& numbering() const { return numbering_; }
  /// First coordinate of a point or vector of the description; the others follow it.
  int coordinate(int entity) const { return numbering_.entity[static_cast<std::size_t>(entity)]; }
  /// Number of the equation of a drive.
  int drive_equation(int drive) const { return first_drive_ + drive; }

  /// For what supports bear: forces on every coordinate; the rows of M that belong to fixed ones (row 0: the
  /// first of them); their rows of Phi_q^T, of which constraints() writes the values behind the pattern's.
  void all_forces(const double* q, const double* v, double* force) const;
  const Matrix& fixed_mass() const { return fixed_mass_; }
  const Pattern& fixed_jacobian() const { return fixed_jacobian_; }

 private:
  void add_masses();
  void add_constraints();
  void place_constraints();
  void add_forces();
  void add_elements();
  void place_forces();
  void add_scales();

  Description description_;
  Numbering numbering_;
  Structure structure_;
  std::vector<std::unique_ptr<ConstraintSet>> sets_;
  std::vector<std::unique_ptr<ForceSet>> force_sets_;
  Matrix fixed_mass_;
  Pattern fixed_jacobian_;
  Eigen::VectorXd weight_;  ///< of each coordinate
  mutable Eigen::VectorXd force_;
  std::vector<InputValue> inputs_;
  InputSource* source_ = nullptr;
  int first_drive_ = 0;
};

}  // namespace tandem::mbs
