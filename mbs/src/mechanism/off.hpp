// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "form.hpp"
#include "quadratic_set.hpp"

namespace tandem::mbs {

// By how many metres or radians equations of squares and products are off.

/// Of Phi = (r^2 - l^2) / l: r - l.
Off off_of_distance(double l, double phi);
/// Of Phi = scale (r^2 - s^2), s the coordinate of that number: r - s.
OffOf off_of_length(int s, double scale);
/// Of the angle phi0 from a to b in the plane, Phi = scale [(a x b) cos(phi0) - (a . b) sin(phi0)].
OffOf off_of_angle(Forms a, Forms b, double phi0, double scale);

}  // namespace tandem::mbs
