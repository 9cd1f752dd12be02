// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::kart {

/// How the force of a kart's tyre follows its slip. All three are pure functions of slip and load.
enum class TyreLaw { linear, magic_formula, tmeasy };
/// "linear", "magic_formula", "tmeasy". Throws Error(invalid_argument) for another name.
TyreLaw tyre_law(const std::string& name);

/// The tyres of both axles differ in their lateral force alone.
enum class Axle { front, rear };

/// Longitudinal: (r w - v) / |v|, positive when driving. Lateral: -v_y / |v|, so that the force has its sign.
struct Slip {
  double longitudinal = 0.0, lateral = 0.0;
};
/// On the kart, forwards and along the lateral direction of `Slip` [N].
struct TyreForce {
  double longitudinal = 0.0, lateral = 0.0;
};

/// Slips beyond -1 to 1 count as -1 and 1; without load (0 or less) there is no force.
/// linear: F = C s with C = 24.7 load (lateral 37 load), cut so that (Fx / 0.9 load)^2 + (Fy / 1.5 load)^2
/// <= 1. magic_formula (H. Pacejka, Tire and Vehicle Dynamics, 2012; numbers of a racing kart: R. Lot, N. Dal
/// Bianco, Vehicle System Dynamics 54 (2016) 210): F = D sin(C atan(x - E (x - atan x))), x = B s, B = K / (C
/// D), times cos(rC atan(rB s)) of the other slip s. tmeasy (G. Rill, Road Vehicle Dynamics, 2011) with
/// forces at loads of 470 and 940 N fitted to the former, linear between, to zero and beyond; combined slip
/// by slips that are divided by s_m + F_m / F'_0.
TyreForce tyre_force(TyreLaw law, Axle axle, const Slip& slip, double load);

/// Above this load [N] a law goes beyond the numbers that it is made of; infinite if it has none.
double largest_load(TyreLaw law);

}  // namespace tandem::kart
