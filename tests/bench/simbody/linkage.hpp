// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "four_bar/course.hpp"

// Simbody's headers are C++17 and don't compile as C++20: they stay behind this one, which is read as both.
namespace tandem::simbody {

/// How the linkage is told to Simbody, which has a tree of bodies (L + 1 cranks and L couplers on pins, or
/// fewer) and closes it by constraints. Both move alike.
enum class Closing {
  /// Every rod is a body; the end of each coupler lies on the axis of the next crank's end: 2L + 1
  /// coordinates, 2L equations.
  point_on_line,
  /// A chain of one crank and all couplers, each of which carries the next crank as what it is in the motion:
  /// a third of its mass at the end and, since half of it hangs there, the weight of a sixth more. The end
  /// stays at 1 m from the pivot: L + 1 coordinates, L equations.
  rod,
};

struct Settings {
  std::string integrator = "RungeKuttaMerson";
  double accuracy = 1e-3;   ///< of a step, by which Simbody chooses the next
  double tolerance = 0.0;   ///< of constraints; 0: Simbody's, a tenth of the accuracy
  double step = 0.0;        ///< [s]; above 0: all steps are as long, with a projection after each
  double patience = 100.0;  ///< [s] of processor time; then the run is given up
};

/// What `integrator` can be.
std::vector<std::string> integrator_names();

/// The linkage by Simbody. Courses are those of its own steps, whatever their lengths.
class Linkage {
 public:
  Linkage(int loops, four_bar::Start start, Closing closing);
  ~Linkage();
  Linkage(const Linkage&) = delete;
  Linkage& operator=(const Linkage&) = delete;

  /// To the time `end` [s]. Throws Error for an integrator that is not there.
  four_bar::Course run(const Settings& settings, double end) const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace tandem::simbody
