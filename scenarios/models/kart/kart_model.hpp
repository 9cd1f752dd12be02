// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/mbs/model.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::kart {

/// A kart in closed formulas: an unconstrained model whose only input is the torque on the driven shaft.
class KartModel : public mbs::Model {
 public:
  const mbs::Structure& structure() const override { return structure_; }
  void at_time(double) override {}
  void constraints(const double*, double*, double*) const override {}
  void constraint_rates(const double*, double*) const override {}
  void constraint_accelerations(const double*, const double*, double*) const override {}
  void force_derivatives(const double* q, const double* v, double* k, double* c) const override;

  /// Ports and feedthrough; the first input is the torque.
  virtual SubsystemInfo info() const = 0;
  /// Those of info() and their derivatives, of a state with accelerations.
  virtual void outputs(const mbs::State& state, double* y) const = 0;
  /// Values between which the model is believed, and where they are in a state.
  virtual std::vector<mbs::Bound> bounds() const { return {}; }
  virtual void watched(const mbs::State&, double*) const {}
  /// At rest on the ground.
  mbs::State standing(double t) const;

  double torque = 0.0;  ///< on the driven shaft [N m]

 protected:
  /// names and masses of the variables; forces of all depend on all.
  KartModel(std::vector<std::string> names, std::vector<double> masses);

 private:
  mbs::Structure structure_;
};

/// Behind the contract, with an own step [s]. "rk4": the classical Runge-Kutta method; "newmark": Newmark's
/// with gamma = 1/2 and `beta` (1/4: the trapezoidal rule).
struct KartSettings {
  double step = 1e-3;
  std::string integrator = "newmark";
  double beta = 0.25;
  mbs::TellOfLimit tell = {};  ///< takes what the model's bounds tell; null: nobody
};
std::unique_ptr<Subsystem> make_subsystem(std::shared_ptr<KartModel> model, const KartSettings& settings);

}  // namespace tandem::kart
