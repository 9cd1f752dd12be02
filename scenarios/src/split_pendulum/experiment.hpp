// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "split_pendulum/model.hpp"
#include "tandem/coordinator/topology.hpp"

namespace tandem::split_pendulum {

/// One way to couple the rods, by the words of files and tables: displacement to the lower rod, force to the
/// upper one. `fast`: the side with the small step, "lower" or "upper". Schedule "monolithic": both rods in
/// one mechanism with the large step, nothing to reconstruct.
struct Scheme {
  std::string schedule = {}, to_lower = {}, to_upper = {}, fast = "lower";
  std::string formulation = "null_space";  ///< of both sides, with Newmark's method
  double ratio = 10.0;                     ///< of the steps
  Lag lag = Lag::none;  ///< of what the upper rod takes: the force, a carried mass's acceleration
  bool monolithic() const { return schedule == "monolithic"; }
};

struct Case {
  Scheme scheme;
  Rods rods{};
  double step = 1e-3;  ///< the large one [s]
};

/// The elbow's distance from its exact motion over 2 s, at the upper rod's own steps [m]. A run is unstable
/// if a side gives up or the distance exceeds 0.5 m.
struct Outcome {
  double largest = 0.0, rms = 0.0;
  bool stable = true;
  std::string note = {};  ///< why not
};
inline constexpr double t_stop = 2.0;  ///< [s]
/// truth: of the same rods.
Outcome run_case(const Case& c, const Truth& truth);

/// The largest ratio of masses with which a scheme is stable, to 1 %: a mass of 1 kg on a spring (40 N/m per
/// kg of both), which takes the force, and rigidly joined to it one that takes the displacement, 1000 large
/// steps of 1 ms. 0: none above 0.001; infinite: 10 is stable too. The carried mass is left out: what counts
/// with it is the ratio of what is left of the partner's mass to what the other side has with it.
double stable_mass_ratio(const Scheme& scheme);

}  // namespace tandem::split_pendulum
