// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "kart/data.hpp"
#include "kart/kart_model.hpp"

namespace tandem::kart {

/// Level i: a point mass that rolls without slip,
///   m_e v' = T / r - c v |v| - f m g tanh(v / 0.1 m/s),  m_e = m + (I_f + I_r) / r^2,
/// with a pitch angle by the weight that its acceleration shifts: -m a h / k, k the pitch stiffness of the
/// springs about the centre of mass. Outputs: shaft_speed [rad/s], pitch [rad], speed [m/s].
class Point final : public KartModel {
 public:
  explicit Point(const KartData& data);

  void forces(const double* q, const double* v, double* force) const override;
  double energy(const double* q, const double* v) const override;
  SubsystemInfo info() const override;
  void outputs(const mbs::State& state, double* y) const override;

 private:
  KartData data_;
};

}  // namespace tandem::kart
