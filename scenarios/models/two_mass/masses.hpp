// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/classical_steps.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/transports/open.hpp"
#include "two_mass/model.hpp"

namespace tandem::two_mass {

/// The fast side: mass 1 by the classical Runge-Kutta method of order 4 (W. Kutta, 1901), inputs read at
/// every stage.
///   m1 x1'' = -k1 x1 - k2 (x1 - x2)
/// Input x2; outputs x1 (with x1', x1''), v1 (with x1''). With `force`: also F = k2 (x1 - x2), the force on
/// mass 2, which follows x2 at once. With `carried_mass` > 0 that much of mass 2 rides here: input a2 = x2''
/// too, and F = k2 (x1 - x2) - carried_mass a2. Inputs may react (reaction.h).
class FastMass {
 public:
  struct Options {
    bool force = false;
    double carried_mass = 0.0;  ///< [kg]
  };
  FastMass(const Model& model, Options options);

  SubsystemInfo info() const;
  double own_step() const { return model_.h1; }
  void start(double t, std::span<const double> u0);
  void react(const Reaction* reaction);
  std::span<const double> reaction_states() const {
    return reaction_ ? std::span(joint_).subspan(2) : std::span<const double>();
  }
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  std::optional<std::vector<StateName>> states() const;
  void get_states(std::span<double> x) const;
  void set_states(std::span<const double> x);
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  double acceleration(double x1, double x2) const;
  double force(double x1, double x2, double a2) const;
  void take_inputs(double x2, double a2);
  struct Joint;
  void step_with_reaction(const OwnStep& s, std::span<const Signal> u);

  Model model_;
  Options options_;
  double x1_ = 0.0, v1_ = 0.0;          ///< state
  double a1_ = 0.0, force_ = 0.0;       ///< with the inputs at the end of the last step
  const Reaction* reaction_ = nullptr;  ///< of this call
  std::vector<double> joint_ = {};      ///< x1, v1, and the states of the reaction
  ClassicalSteps<Joint> steps_ = {};
};

/// The slow side: mass 2 by the trapezoidal rule, solved exactly.
///   m x2'' = g u - K x2:  u = x1, g = k2, K = k2 + k3, m = m2;  or, with `force`, u = F, g = 1, K = k3,
/// m = m2 - carried_mass.
/// At each step u is read anew at both ends. Outputs x2 (with x2', x2''), v2 (with x2''), and with `force` a2
/// = x2'', which follows F at once.
class SlowMass {
 public:
  struct Options {
    bool force = false;
    double carried_mass = 0.0;  ///< [kg]
    bool reuse_acceleration =
        false;  ///< the mistake that the docs show: start the step with the last one's acceleration
  };
  SlowMass(const Model& model, Options options);

  SubsystemInfo info() const;
  double own_step() const { return model_.h2; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  std::optional<std::vector<StateName>> states() const;
  void get_states(std::span<double> x) const;
  void set_states(std::span<const double> x);
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  Model model_;
  Options options_;
  double gain_, stiffness_, mass_;
  double x2_ = 0.0, v2_ = 0.0, a2_ = 0.0;
};

/// Both masses in one subsystem by the classical Runge-Kutta method with the fast side's step: the reference,
/// and the cost to beat. Outputs x1, v1, x2, v2.
class BothMasses {
 public:
  explicit BothMasses(const Model& model) : model_(model) {}

  SubsystemInfo info() const;
  double own_step() const { return model_.h1; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  std::optional<std::vector<StateName>> states() const;
  void get_states(std::span<double> x) const;
  void set_states(std::span<const double> x);
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  Model model_;
  Motion state_{};
};

/// The exact motion at the fast side's steps. Outputs x1 (with x1', x1''), v1 (with x1''), x2, v2 likewise.
class ExactMasses {
 public:
  explicit ExactMasses(const Model& model) : model_(model) {}

  SubsystemInfo info() const;
  double own_step() const { return model_.h1; }
  void start(double t, std::span<const double> /*u0*/) { t_ = t; }
  void step(const OwnStep& s, std::span<const Signal> /*u*/) { t_ = s.end; }
  void outputs(double* y) const;
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  Model model_;
  double t_ = 0.0;
};

/// two_mass.fast, .slow, .fast_force, .slow_force, .both, .exact, with the names of Settings as parameters.
void add_builtins(Builtins& builtins);

}  // namespace tandem::two_mass
