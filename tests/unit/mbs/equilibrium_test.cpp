// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Where mechanisms come to rest, from drawings far from there.
#include "tandem/mbs/mechanism/equilibrium.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "refusal.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

const std::string rests = "[initial]\nequilibrium = true\n";

/// A mass on a spring of 1 m drawn beside where it hangs: on the way down the sum of squares of the forces
/// passes a hill, as the spring does not pull across itself. Forces are balanced to 1e-10 of the largest, 2.8
/// kN, against m g/l across.
TEST(Equilibrium, OfAMassOnASpringIsBelowItsAnchor) {
  Mechanism m(
      read_mechanism("m",
                     "dimension = 2\ngravity = [0, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\n"
                     "P = { at = [0.5, 0.2] }\n[masses]\nm = { point = 'P', mass = 0.1 }\n[springs]\n"
                     "s = { points = ['O', 'P'], stiffness = 6000, free = 1 }\n" +
                         rests));
  const State s = initial_state(m, 0.0);
  EXPECT_NEAR(s.q[0], 0.0, 3e-7);
  EXPECT_NEAR(s.q[1], -(1.0 + 0.981 / 6000), 1e-9);
}

/// One to five points, each on a rod or on a spring and with a mass, hung on one of those before, and a
/// spring between two of them.
class RandomDrawing {
 public:
  explicit RandomDrawing(unsigned seed) : engine_(seed), dimension_(whole(2) == 0 ? 2 : 3) {}

  std::string text() {
    const int hung = 1 + whole(5);
    std::string points = "[points]\nG = { at = " + place() + ", fixed = true }\n", parts;
    for (int k = 0; k < hung; ++k) {
      points += fmt::format("P{} = {{ at = {} }}\n", k, place());
      parts += part(k, whole(k + 1));
    }
    if (hung > 1) parts += spring("more", name(1 + whole(hung - 1)), name(0));
    return fmt::format("dimension = {}\ngravity = {}\n", dimension_,
                       dimension_ == 2 ? "[0, -9.81]" : "[0, 0, -9.81]") +
           points + parts + rests;
  }

 private:
  static std::string name(int k) { return k == 0 ? "G" : fmt::format("P{}", k - 1); }
  double number() { return static_cast<double>(engine_()) / 4294967296.0; }
  int whole(int below) { return static_cast<int>(number() * below); }
  std::string place() {
    std::string text;
    for (int k = 0; k < dimension_; ++k)
      text += fmt::format("{}{:.6f}", k == 0 ? "[" : ", ", 2.0 * number() - 1.0);
    return text + "]";
  }
  std::string part(int k, int on) {
    const std::string point = name(k + 1);
    if (whole(2) == 0)
      return fmt::format("[rods.r{}]\npoints = ['{}', '{}']\nmass = 1\n", k, name(on), point);
    return fmt::format("[masses.m{}]\npoint = '{}'\nmass = 0.5\n", k, point) +
           spring(fmt::format("s{}", k), name(on), point);
  }
  std::string spring(const std::string& of, const std::string& from, const std::string& to) {
    return fmt::format("[springs.{}]\npoints = ['{}', '{}']\nstiffness = {:.4g}\nfree = {:.3f}\n", of, from,
                       to, std::pow(10.0, 1.0 + 3.0 * number()), 0.1 + 1.4 * number());
  }

  std::mt19937 engine_;
  int dimension_;
};

/// Accelerations are the dynamics' own. Forces are balanced to 1e-7 of the largest on the way, some 1e4 N, on
/// masses of 1/6 kg and more.
TEST(Equilibrium, IsFoundFromRandomDrawings) {
  StepperSettings settings;
  settings.formulation = "index1";
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const std::string text = RandomDrawing(seed).text();
    Mechanism m(read_mechanism("m", text));
    State s;
    ASSERT_NO_THROW(s = initial_state(m, 0.0)) << text;
    make_stepper(m, settings)->start(s);
    EXPECT_LT(s.a.lpNorm<Eigen::Infinity>(), 6e-3) << text;
  }
}

TEST(Equilibrium, IsRefusedWhereNothingHoldsAWeight) {
  EXPECT_TRUE(
      test::refuses(ErrorCode::numerical, {"no equilibrium is found: P.y is left with a force of -9.81"}, [] {
        Mechanism m(read_mechanism("m",
                                   "dimension = 2\ngravity = [0, -9.81]\n[points]\nP = { at = [0, 0] }\n"
                                   "[masses]\nm = { point = 'P', mass = 1, free = true }\n" +
                                       rests));
        initial_state(m, 0.0);
      }));
}

}  // namespace
}  // namespace tandem::mbs
