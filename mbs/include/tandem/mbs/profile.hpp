// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

namespace tandem::mbs {

/// What a step of index3 consists of (F. Gonzalez, doctoral thesis, A Coruna 2010): motion predicted and
/// corrected; constraints, Jacobian, forces and their derivatives; assembly of the tangent; residual; its
/// factorization; substitution in the iteration; the two projections, with their substitutions.
enum class Task {
  update,
  dynamic_terms,
  tangent,
  residual,
  factorization,
  substitution,
  velocity_projection,
  acceleration_projection
};
constexpr std::size_t task_count = 8;
/// "dynamic terms" and so on, by Task.
extern const std::array<const char*, task_count> task_names;

/// Seconds of this thread's steps by Task since the last clear_profile(). Each reading of the clock costs
/// some 20 ns. Throws Error(not_supported) if tandem was built without -DTANDEM_PROFILE=ON.
const std::array<double, task_count>& profile();
void clear_profile();

}  // namespace tandem::mbs
