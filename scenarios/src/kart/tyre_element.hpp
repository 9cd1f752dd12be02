// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "kart/tyres.hpp"
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem::kart {

/// "tyre", in space: a wheel on level ground at height 0, or at that of an input. Keys: `centre` (a point),
/// `axis` (its vector e, to the left, of length 1), and either `spin` (the coordinate of its absolute spin)
/// or `spokes` (two vectors m, n that turn with it, (e, m, n) a right-handed frame); `law` (tyres.hpp),
/// `axle` ("front" or "rear"), `radius`, `free_radius` [m], `stiffness` [N/m], `damping` [N s/m], `rolling`,
/// `relaxation` [m]; `lateral` (true), `ground` (an input, [m]), `brake` (an input, [N m], not below 0) with
/// `lower` and `upper`, two points of the upright that carries it, across from the axis. With e_x along the
/// wheel, e_y across, z the height of the centre, W the spin and sigma the relaxation length,
///   load = k (R - z) - c z' >= 0,  s_x = r W - C' . e_x,  s_y = -C' . e_y - z e' . e_z,
///   sigma kappa' = s - |v_x| kappa, one for each direction,
///   slip = kappa + 0.05 s/m exp(-|v_x| / 1 m/s) s, which damps where the kart hardly moves.
/// The force acts on the ground under the centre, with the couple -f load r tanh(W r / 0.1 m/s) e against
/// rolling. The brake's couple is -T tanh(w r / 0.1 m/s) e on the wheel, the opposite on the upright, w the
/// wheel's spin over that of the upright. Quantities: load [N], slip, side_slip, drive and side (forces [N]),
/// loss [W]: what tyre and rolling take, and the brake; of ground that stands.
///
/// "plane_tyres", in the plane: both wheels of an axle. Keys: `centre`, `rim` (two points of the wheels'
/// body), and those above but `lateral` and `ground`; numbers are of one tyre, load and drive too.
///
/// `law` is asked for each tyre: a law in place of that of the file, unless it is empty.
mbs::ElementKinds element_kinds(const LawChoice& law = {});

std::unique_ptr<mbs::ForceElement> make_tyre(mbs::ElementKeys& keys, const LawChoice& law);
std::unique_ptr<mbs::ForceElement> make_plane_tyres(mbs::ElementKeys& keys, const LawChoice& law);

}  // namespace tandem::kart
