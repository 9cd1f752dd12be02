// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/examples.hpp"

#include <cmath>

#include "four_bar/linkage.hpp"
#include "mechanisms/andrews.hpp"
#include "mechanisms/bricard.hpp"
#include "mechanisms/double_pendulum.hpp"
#include "mechanisms/pendulum.hpp"
#include "mechanisms/rotor.hpp"
#include "mechanisms/slider_crank.hpp"
#include "mechanisms/spatial_slider_crank.hpp"
#include "mechanisms/spherical_pendulum.hpp"
#include "mechanisms/spring_pendulum.hpp"
#include "tandem/error.hpp"

namespace tandem::mechanisms {
namespace {

using mbs::Mechanism;
using mbs::State;

/// A point's place.
Eigen::VectorXd place(const Mechanism& m, const State& s, const std::string& name) {
  const mbs::Description& in = m.description();
  for (std::size_t e = 0; e < in.entities.size(); ++e)
    if (in.entities[e].name == name) return s.q.segment(m.coordinate(static_cast<int>(e)), in.dimension);
  throw Error(ErrorCode::internal, "no point " + name);
}

double pendulum_error(const Mechanism& m, const State& s) {
  return (place(m, s, "P") - pendulum(s.time).tip).norm();
}

double double_pendulum_error(const Mechanism& m, const State& s) {
  const auto truth = double_pendulum(s.time);
  return std::hypot((place(m, s, "A") - truth.elbow).norm(), (place(m, s, "B") - truth.tip).norm());
}

double spherical_pendulum_error(const Mechanism& m, const State& s) {
  return (place(m, s, "P") - spherical_pendulum(s.time).tip).norm();
}

double slider_crank_error(const Mechanism& m, const State& s) {
  return std::hypot(s.q[m.numbering().relative[0]] - slider_crank(s.time).angle,
                    place(m, s, "S")[0] - slider_crank(s.time).slider);
}

double spring_pendulum_error(const Mechanism& m, const State& s) {
  return (place(m, s, "P") - spring_pendulum(s.time).position).norm();
}

double four_bar_error(const Mechanism& m, const State& s) {
  return std::abs(s.q[m.coordinate(0)] - std::sin(four_bar::exact(5, s.time).angle));
}

double andrews_error(const Mechanism& m, const State& s) {
  const auto joints = andrews(s.time).joints;
  double square = 0.0;
  for (const auto& [name, truth] :
       {std::pair{"F", joints.F}, {"E", joints.E}, {"G", joints.G}, {"H", joints.H}})
    square += (place(m, s, name) - truth).squaredNorm();
  return std::sqrt(square);
}

double bricard_error(const Mechanism& m, const State& s) {
  return (place(m, s, "P3") - bricard(s.time).points[3]).norm();
}

double axes_error(const Mechanism& m, const State& s, const RotorState& truth) {
  double square = 0.0;
  for (int k = 0; k < 3; ++k)
    square += (place(m, s, "e" + std::to_string(k + 1)) - truth.axes.col(k)).squaredNorm();
  return std::sqrt(square);
}

double rotor_error(const Mechanism& m, const State& s) { return axes_error(m, s, rotor(s.time)); }

double asymmetric_rotor_error(const Mechanism& m, const State& s) {
  return axes_error(m, s, asymmetric_rotor(s.time));
}

double spatial_slider_crank_error(const Mechanism& m, const State& s) {
  return (place(m, s, "C") - spatial_slider_crank(s.time).slider).norm();
}

}  // namespace

const std::vector<Example>& examples() {
  static const std::vector<Example> all = {{"pendulum", 2.0, 1000, pendulum_error},
                                           {"double_pendulum", 1.0, 1000, double_pendulum_error},
                                           {"spherical_pendulum", 2.0, 1000, spherical_pendulum_error},
                                           {"slider_crank", 1.0, 2000, slider_crank_error},
                                           {"spring_pendulum", 2.0, 1000, spring_pendulum_error},
                                           {"four_bar", 0.5, 500, four_bar_error},
                                           {"andrews", 0.03, 1000, andrews_error},
                                           {"bricard", 1.0, 1000, bricard_error},
                                           {"rotor", 1.0, 1000, rotor_error},
                                           {"asymmetric_rotor", 1.0, 1000, asymmetric_rotor_error},
                                           {"spatial_slider_crank", 1.0, 2000, spatial_slider_crank_error}};
  return all;
}

}  // namespace tandem::mechanisms
