// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "kart/tyres.hpp"
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem::kart {

/// "tyre", in space: a wheel on level ground at height 0, or at that of an input. Keys: `centre` (a point),
/// `axis` (its vector e, to the left, of length 1), and either `spin` (the coordinate of its absolute spin)
/// or `spokes` (two vectors m, n that turn with it, (e, m, n) a right-handed frame); `law` (tyres.hpp),
/// `axle` ("front" or "rear"), `lever` ("radius"), `radius`, `free_radius` [m], `stiffness` [N/m], `damping`
/// [N s/m], `rolling`, `relaxation` [m]; `lateral` (true), `ground` (an input, [m]), `brake` (an input,
/// [N m], not below 0) with `lower` and `upper`, two points of the upright that carries it, across from the
/// axis. With e_x along the wheel, e_y across, z the height of the centre, W the spin and sigma the
/// relaxation length,
///   load = k (R - z) - c z' >= 0,  s_x = r W - C' . e_x,  s_y = -C' . e_y - z w . e_x,
///   sigma kappa' = s - |v_x| kappa, one for each direction,
///   slip = kappa + 0.05 s/m exp(-|v_x| / 1 m/s) s, which damps where the kart hardly moves.
/// w is the turn of the axis: w . e_x = e' . e_z over the cosine of the camber. The force acts on the centre;
/// with it go the couples -F_x r e about the axle, z F_y e_x of the force across, which stays on the ground,
/// and -f load r tanh(W r / 0.1 m/s) e against rolling. With r for lever, as in s_x, what the tyre takes is
/// F_x s_x + F_y s_y, and a wheel that rolls free passes on what it is given. (r - z) F_x is then a moment of
/// the ground: where the load presses moves by that over the load. `lever` = "height" instead of "radius"
/// puts F_x on the ground below the centre (-F_x z e_y), as printed in the specification: this wheel makes
/// F_x (r - z) W. The brake's couple is -T tanh(w r / 0.1 m/s) e on the wheel, the opposite on the upright, w
/// the wheel's spin over that of the upright. Quantities: load and excess, that over largest_load() of the
/// law [N], slip, side_slip, drive and side (forces [N]); slip_loss, rolling_loss, damping_loss (of the
/// load), brake_loss [W], of ground that stands.
///
/// "plane_tyres", in the plane: both wheels of an axle. Keys: `centre`, `rim` (two points of the wheels'
/// body), and those above but `lateral`, `ground` and the brake's; numbers are of one tyre, and quantities.
mbs::ElementKinds element_kinds();

std::unique_ptr<mbs::ForceElement> make_tyre(mbs::ElementKeys& keys);
std::unique_ptr<mbs::ForceElement> make_plane_tyres(mbs::ElementKeys& keys);
void keys_of_tyre(text::KeyList& to);
void keys_of_plane_tyres(text::KeyList& to);

}  // namespace tandem::kart
