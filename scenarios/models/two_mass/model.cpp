// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tandem/error.hpp"

namespace tandem::two_mass {
namespace {

void require(bool holds, const std::string& setting, double value, const std::string& allowed) {
  if (!holds || !std::isfinite(value))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("two_mass: {} is {}; allowed is {}", setting, value, allowed));
}

/// The range of b = C13/C23 in which k1 and k3 are positive, with s = FR^2 - 1 and a = C11/C21:
/// k3 > 0 for b > (s + a)/(s + 1), k1 > 0 for 1/b > (s + 1/a)/(s + 1).
std::string stiffness_range(double frequency_ratio, double a) {
  const double s = frequency_ratio * frequency_ratio - 1.0;
  const std::string below =
      s + 1.0 / a > 0.0 ? fmt::format(" and below {:.9g}", (s + 1.0) / (s + 1.0 / a)) : "";
  return fmt::format("above {:.9g}{} at frequency_ratio {}, so that k1 and k3 are positive",
                     std::max(0.0, (s + a) / (s + 1.0)), below, frequency_ratio);
}

constexpr std::pair<const char*, double Settings::*> numbers[] = {
    {"frequency_ratio", &Settings::frequency_ratio},
    {"c11", &Settings::c11},
    {"c11_over_c13", &Settings::c11_over_c13},
    {"c11_over_c23", &Settings::c11_over_c23},
    {"c23_over_c21", &Settings::c23_over_c21},
    {"k2", &Settings::k2},
    {"phase1", &Settings::phase1},
    {"phase2", &Settings::phase2},
    {"steps_per_cycle", &Settings::steps_per_cycle},
};

}  // namespace

Settings Settings::from(Parameters& p) {
  Settings s;
  for (const auto& [name, member] : numbers) s.*member = p.number(name, s.*member);
  return s;
}

Words Settings::words() {
  Words all;
  for (const auto& [name, member] : numbers) all.push_back({name, Setter::client});
  return all;
}

Model::Model(const Settings& s) : k2(s.k2), phase1(s.phase1), phase2(s.phase2) {
  require(s.frequency_ratio > 1.0 && s.frequency_ratio <= 1e6, "frequency_ratio", s.frequency_ratio,
          "above 1, up to 1e6");
  require(s.k2 > 0.0, "k2", s.k2, "above 0 N/m");
  require(s.c11 != 0.0, "c11", s.c11, "any length but 0 m");
  require(s.c11_over_c13 != 0.0, "c11_over_c13", s.c11_over_c13, "any number but 0");
  require(s.c11_over_c23 != 0.0, "c11_over_c23", s.c11_over_c23, "any number but 0");
  require(s.c23_over_c21 != 0.0, "c23_over_c21", s.c23_over_c21, "any number but 0");
  require(s.steps_per_cycle > 0.0, "steps_per_cycle", s.steps_per_cycle, "above 0");
  require(true, "phase1", s.phase1, "finite");
  require(true, "phase2", s.phase2, "finite");
  c11 = s.c11;
  c13 = s.c11 / s.c11_over_c13;
  c23 = s.c11 / s.c11_over_c23;
  c21 = c23 / s.c23_over_c21;
  omega1 = 2.0 * std::numbers::pi;
  omega2 = omega1 / s.frequency_ratio;
  const double a = c11 / c21, b = c13 / c23, difference = omega1 * omega1 - omega2 * omega2;
  require(
      a < 0.0 && b > 0.0, "c11_over_c21 (= c11_over_c23 * c23_over_c21)", a,
      "below 0, with c13_over_c23 (= c11_over_c23 / c11_over_c13) above 0, so that the masses are positive");
  m1 = k2 * (a - b) / (a * b * difference);
  m2 = k2 * (b - a) / difference;
  k1 = k2 / b - k2 + omega2 * omega2 * m1;
  k3 = b * k2 - k2 + omega2 * omega2 * m2;
  require(k1 > 0.0 && k3 > 0.0, "c13_over_c23 (= c11_over_c23 / c11_over_c13)", b,
          stiffness_range(s.frequency_ratio, a));
  h1 = 1.0 / s.steps_per_cycle;
  h2 = s.frequency_ratio / s.steps_per_cycle;
}

Motion Model::exact(double t) const {
  const double p = omega1 * t + phase1, q = omega2 * t + phase2;
  return {c11 * std::cos(p) + c13 * std::cos(q), -omega1 * c11 * std::sin(p) - omega2 * c13 * std::sin(q),
          c21 * std::cos(p) + c23 * std::cos(q), -omega1 * c21 * std::sin(p) - omega2 * c23 * std::sin(q)};
}

double Model::energy(const Motion& m) const {
  const double stretch = m.x1 - m.x2;
  return 0.5 *
         (m1 * m.v1 * m.v1 + m2 * m.v2 * m.v2 + k1 * m.x1 * m.x1 + k2 * stretch * stretch + k3 * m.x2 * m.x2);
}

}  // namespace tandem::two_mass
