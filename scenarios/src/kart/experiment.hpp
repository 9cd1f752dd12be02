// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "kart/trace.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::kart {

inline constexpr double engine_step = 1e-4, t_stop = 10.0;  // [s]

/// Where the files of the scene are, and what opens them.
struct Scene {
  std::filesystem::path folder;  ///< scenarios/kart
  const Builtins& builtins;
};

/// The kart of a level with an own step of `ratio` engine steps: point, plane, spatial, spatial_scalar_spin.
/// The last by Newmark's method with beta = 1/12, of which the period's error is of order 4, the others by
/// the trapezoidal rule.
struct Kart {
  std::string level;
  int ratio = 1;
  double step() const { return ratio * engine_step; }
};

/// How kart and engine are coupled: the kart's speeds to the engine, the torque to the kart.
struct Scheme {
  std::string schedule, to_fast, to_slow;
};

/// What a run gave.
struct Course {
  std::vector<double> pitch;   ///< [deg] at the kart's own steps
  std::vector<double> torque;  ///< on the driven shaft, at the engine's [N m]
  double seconds = 0.0;        ///< without its start
  double coordinator_share = 0.0, kart_share = 0.0, engine_share = 0.0;  ///< of these, if they were taken
  std::string failure = {};                                              ///< what ended it early
  Trace trace = {};
};

/// The manoeuvre, coupled. profile: shares are taken too.
Course couple(const Scene& scene, const Kart& kart, const Scheme& scheme, bool profile = false);

/// The kart alone with a torque that is recorded at engine steps: as the kart's own steps find it, or its
/// mean over each of them.
Course replay(const Scene& scene, const Kart& kart, const std::vector<double>& torque, bool mean);

/// Of the pitch at equal times, in degrees; `finer` may have a multiple of the other's steps.
struct Difference {
  double largest = 0.0, rms = 0.0;
};
Difference difference(const Course& course, const Course& finer);

}  // namespace tandem::kart
