// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/integrate.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"

namespace tandem::four_bar {
namespace {

Knot knot(const mbs::Mechanism& linkage, const mbs::State& s) {
  const int first = linkage.coordinate(0), points = linkage.structure().variables / 2;
  const double x = s.q[first], y = s.q[first + 1];
  double skew = 0.0;
  for (int i = 1; i < points; ++i) {
    const int c = linkage.coordinate(i);
    skew = std::max(skew, std::hypot(s.q[c] - x - i, s.q[c + 1] - y));
  }
  return {s.time, x, y, s.v[first], s.v[first + 1], skew};
}

}  // namespace

Course integrate(const mbs::Mechanism& linkage, mbs::Stepper& stepper, double end, long steps) {
  Course course;
  course.knots.reserve(static_cast<std::size_t>(steps) + 1);
  mbs::State s = linkage.described_state();
  const double began = thread_seconds(), h = end / static_cast<double>(steps);
  try {
    stepper.start(s);
    course.knots.push_back(knot(linkage, s));
    for (long k = 1; k <= steps && course.ended == Course::Ended::at_the_end; ++k) {
      stepper.step(s, h, static_cast<double>(k) * h);
      course.knots.push_back(knot(linkage, s));
      if (lost(course.knots.back())) course.ended = Course::Ended::lost;
    }
  } catch (const Error& error) {
    course.ended = Course::Ended::failed;
    course.reason = error.what();
  }
  course.seconds = thread_seconds() - began;
  return course;
}

}  // namespace tandem::four_bar
