// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

const std::string plane = "dimension = 2\ngravity = [0, -9.81]\n";

/// A rod of 1 m and 1 kg, drawn aside.
const std::string rod = plane +
                        "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [0.6, -0.8] }\n"
                        "[rods.arm]\npoints = [\"O\", \"P\"]\nmass = 1\n[initial]\nequilibrium = true\n";

TEST(Equilibrium, RodHangsDown) {
  Mechanism m(read_mechanism("rod", rod));
  const State s = initial_state(m, 0.0);
  EXPECT_NEAR(s.q[0], 0.0, 1e-9);
  EXPECT_NEAR(s.q[1], -1.0, 1e-9);
}

/// 2 kg on 100 N/m, 1 m long when free, from 3 m.
TEST(Equilibrium, MassHangsOnItsSpringByItsWeight) {
  Mechanism m(read_mechanism(
      "mass",
      plane + "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [0.3, -3] }\n"
              "[masses.load]\npoint = \"P\"\nmass = 2\n[inputs]\npush = { unit = \"N\", polynomial = [50] }\n"
              "[springs.s]\npoints = [\"O\", \"P\"]\nstiffness = 100\nfree = 1\n"
              "[forces.f]\npoint = \"P\"\ndirection = [0, 1]\nmagnitude = \"push\"\n"
              "[initial]\nequilibrium = true\n"));
  const State s = initial_state(m, 0.0);  // the input, a function of time, has no part in it
  EXPECT_NEAR(s.q[0], 0.0, 1e-8);
  EXPECT_NEAR(s.q[1], -1.0 - 2.0 * 9.81 / 100.0, 1e-8);
}

TEST(Equilibrium, WhatFallsIsRefusedByName) {
  Mechanism m(read_mechanism("ball", plane +
                                         "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [0, -1] }\n"
                                         "[masses.ball]\npoint = \"P\"\nmass = 2\nfree = true\n"
                                         "[initial]\nequilibrium = true\n"));
  try {
    initial_state(m, 0.0);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("P.y"), std::string::npos) << error.what();
  }
}

/// (3 g / 2 l)^(1/2).
TEST(Modes, RodSwingsWithItsFrequency) {
  Mechanism m(read_mechanism("rod", rod));
  const auto all = modes(m, initial_state(m, 0.0));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].frequency(), std::sqrt(1.5 * 9.81) / (2.0 * std::numbers::pi), 1e-7);
  EXPECT_NEAR(all[0].damping(), 0.0, 1e-9);
  EXPECT_EQ(name_of(m, all[0]), "arm along x");
}

/// w^2 = k / m, 2 zeta w = c / m along the spring; across it the length l swings with w^2 = g / l.
TEST(Modes, MassOnADampedSpring) {
  Mechanism m(read_mechanism(
      "mass", plane + "[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [0, -1] }\n"
                      "[masses.load]\npoint = \"P\"\nmass = 2\n"
                      "[springs.s]\npoints = [\"O\", \"P\"]\nstiffness = 100\ndamping = 4\nfree = 1\n"
                      "[initial]\nequilibrium = true\n"));
  const auto all = modes(m, initial_state(m, 0.0));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].frequency() * 2.0 * std::numbers::pi, std::sqrt(9.81 / 1.1962), 1e-6);
  EXPECT_EQ(name_of(m, all[0]), "load along x");
  EXPECT_NEAR(all[1].frequency() * 2.0 * std::numbers::pi, std::sqrt(50.0), 1e-6);
  EXPECT_NEAR(all[1].damping(), 4.0 / (2.0 * std::sqrt(200.0)), 1e-8);
  EXPECT_EQ(name_of(m, all[1]), "load along y");
}

/// Eigen's solver has no answer for a matrix without rows.
TEST(Modes, AStructureHasNone) {
  Mechanism m(read_mechanism(
      "truss", plane + "[points]\nA = { at = [0, 0], fixed = true }\nB = { at = [1, 0], fixed = true }\n"
                       "C = { at = [0.5, 1] }\n[masses.load]\npoint = \"C\"\nmass = 1\n"
                       "[distances]\nAC = { points = [\"A\", \"C\"] }\nBC = { points = [\"B\", \"C\"] }\n"));
  EXPECT_TRUE(modes(m, initial_state(m, 0.0)).empty());
}

TEST(Modes, AnInputWithoutAValueIsRefused) {
  Mechanism m(read_mechanism(
      "pushed", plane + "[points]\nP = { at = [0, 0] }\n[masses.load]\npoint = \"P\"\nmass = 1\n"
                        "[inputs.push]\nunit = \"N\"\n"
                        "[forces.push]\npoint = \"P\"\ndirection = [1, 0]\nmagnitude = \"push\"\n"));
  EXPECT_THROW(modes(m, initial_state(m, 0.0)), Error);
}

}  // namespace
}  // namespace tandem::mbs
