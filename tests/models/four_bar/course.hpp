// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ctime>
#include <string>
#include <vector>

#include "four_bar/linkage.hpp"

namespace tandem::four_bar {

/// The linkage at the end of a step.
struct Knot {
  double time;          ///< [s]
  double x, y, vx, vy;  ///< of the first moving point, from its pivot [m], [m/s]
  double skew;  ///< of the other moving points, the largest distance from where the first would have them [m]
};

/// What a run of the linkage leaves, by whatever code.
struct Course {
  enum class Ended { at_the_end, lost, failed, given_up };
  std::vector<Knot> knots;  ///< the start, then the end of each step
  double seconds = 0.0;     ///< thread_seconds() from the described positions and velocities to the end
  Ended ended = Ended::at_the_end;
  std::string reason = {};  ///< why it failed
};

/// Processor time of this thread [s]: what other work on the machine takes is not in it.
inline double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Root mean square of the first moving point's distance from its exact path [m] at 0, interval, ...; between
/// knots it moves on cubic Hermite polynomials. NaN for a course that ended early.
double rms_error(const Course& course, const std::vector<Crank>& exact, double interval);

/// Whether it is no parallelogram any more, by a tenth of a rod: where a run is ended.
inline bool lost(const Knot& knot) { return !(knot.skew <= 0.1); }

/// "ok", "lost at 2.7 s", "failed at 3.2 s", "given up at 3.2 s".
std::string status(const Course& course);

}  // namespace tandem::four_bar
