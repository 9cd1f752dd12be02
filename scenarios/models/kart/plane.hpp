// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "kart/data.hpp"
#include "kart/kart_model.hpp"
#include "kart/tyres.hpp"

namespace tandem::kart {

/// Level ii: the pitch plane in closed formulas for small angles, 7 degrees of freedom: x forwards, and from
/// rest z of the sprung mass, pitch psi (nose down positive), z_f and z_r of the axles; the turns of both
/// axles' wheels. Two variables besides have the slips kappa for rates: sigma kappa' = (r w - v) - |v| kappa.
/// With springs F_s = 2 [k (z_j - z_mj) + c (z_j' - z_mj')], mounts z_mf = z - a_s psi, z_mr = z + b_s psi,
/// wheel loads F_z = F_z0 - 2 (k_t z_j + c_t z_j') >= 0 and tyre forces F_x (half the load each):
///   m x'' = F_xf + F_xr - c v |v|,  m_s z'' = F_sf + F_sr,  m_uj z_j'' = F_zj - F_zj0 - F_sj,
///   I_yy psi'' = -a_s F_sf + b_s F_sr + (r - h_s)(F_xf + F_xr - m_u x'') - T,
///   I_f w_f' = -F_xf r - M_f,  I_r w_r' = T - F_xr r - M_r,  M = f F_z r tanh(w r / 0.1 m/s).
/// These are the printed formulas. They leave out that the axles, which the chassis guides, move against its
/// centre of mass when it pitches: x_j = x + a_j - (d + l_j) psi - a_j psi^2 / 2, with d = h_s - r, a_f =
/// a_s, a_r = -b_s, and l_j = z - z_j - a_j psi + d psi^2 / 2 by which the spring is longer.
/// Formulas::complete have, to second order in the displacements, x that of the sprung mass, H_j = F_xj -
/// m_uj x'' and S_j = -2 (k_j l_j + c_j l_j'):
///   m x'' - m_u d psi'' = F_x - c x' |x'|,  m_s z'' = sum (S_j - H_j psi),
///   m_uj z_j'' = F_zj - F_zj0 - S_j + H_j psi,
///   (I_yy + m_u d^2) psi'' - m_u d x'' = sum (-a_j S_j + d psi S_j - d F_xj - H_j l_j) + m_s g d psi - T,
/// and x_j' for the speed of the wheels over the ground; the shaft turns with w_r - psi' against the chassis.
/// Where the kart hardly moves the slip is kappa + 0.05 s/m exp(-|v| / 1 m/s)(r w - v), which damps its
/// swinging on the tyres. Outputs: shaft_speed [rad/s], pitch [rad], speed [m/s], and of one wheel of each
/// axle load [N] and slip.
class Plane final : public KartModel {
 public:
  enum class Formulas { printed, complete };
  Plane(const KartData& data, TyreLaw law, Formulas formulas = Formulas::printed);

  void forces(const double* q, const double* v, double* force) const override;
  double energy(const double* q, const double* v) const override;  ///< of masses and springs
  SubsystemInfo info() const override;
  void outputs(const mbs::State& state, double* y) const override;
  /// Told: wheels off the ground, a tyre's load beyond its law's data. A pitch beyond 0.7 rad ends a run.
  std::vector<mbs::Bound> bounds() const override;
  void watched(const mbs::State& state, double* values) const override;

 private:
  struct Contact {
    double up, up_rate, spring;  ///< of the chassis over the axle, where they are guided; S
    double speed, load, slip, slip_rate, force, resistance;  ///< of the axle; resistance: to rolling [N m]
  };
  Contact contact(Axle axle, const double* q, const double* v) const;
  void add_shift(double tyres, double* force) const;
  void complete(const Contact& front, const Contact& rear, double tilt, double* force) const;

  KartData data_;
  TyreLaw law_;
  double guide_;  ///< d [m]; 0 with the printed formulas
};

}  // namespace tandem::kart
