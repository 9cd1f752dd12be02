// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

namespace tandem::mbs {

/// What a step of index3 consists of (F. Gonzalez, doctoral thesis, A Coruna 2010).
enum class Task {
  update,         ///< motion predicted and corrected
  dynamic_terms,  ///< constraints, Jacobian, forces and their derivatives
  tangent,        ///< its assembly
  residual,
  factorization,           ///< of the tangent
  substitution,            ///< in the iteration
  velocity_projection,     ///< with its substitutions
  acceleration_projection  ///< likewise
};
constexpr std::size_t task_count = 8;
/// "dynamic terms" and so on, by Task.
extern const std::array<const char*, task_count> task_names;

/// Seconds of this thread's steps by Task since the last clear_profile(). Each reading of the clock costs
/// some 20 ns. Throws Error(not_supported) if tandem was built without -DTANDEM_PROFILE=ON.
const std::array<double, task_count>& profile();
void clear_profile();

}  // namespace tandem::mbs
