// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Free coordinates, relations, slides, distances between places, and elements in files.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

/// A plate on the ground's axes, and a point that slides along it by a coordinate.
const std::string text =
    "dimension = 2\n[points]\nA = { at = [0, 0], fixed = true }\nB = { at = [1, 0] }\n"
    "S = { at = [0.5, 0.2], massless = true }\n"
    "[bodies.plate]\npoints = [\"A\", \"B\"]\nmass = 1\ncentre = [0.5, 0]\ninertia = 0.1\n"
    "[coordinates]\nway = { unit = \"m\" }\nhalf = { unit = \"m\", inertia = 2 }\n"
    "[slides.s]\npoint = \"S\"\non = \"plate\"\nalong = [1, 0]\ncoordinate = \"way\"\n"
    "[relations.gear]\nterms = { way = 1, half = -2 }\n";

State stands(Mechanism& m) { return initial_state(m, 0.0); }

TEST(ReadElements, PointSlidesOnABodyByACoordinate) {
  Mechanism m(read_mechanism("slide", text + "[initial]\npositions = { half = 0.05, \"B.x\" = 0 }\n"
                                             "[drives]\n"));
  const State s = stands(m);
  EXPECT_EQ(m.structure().constraints, 4);  // one of the plate, two of the slide, the relation
  EXPECT_EQ(freedom(m, s).degrees, 2);
  // The plate stands upright, up or down; the point is 0.6 m along it and 0.2 m to its left.
  const double up = s.q[1];
  EXPECT_NEAR(std::abs(up), 1.0, 1e-9);
  EXPECT_NEAR(s.q[2], -0.2 * up, 1e-9);
  EXPECT_NEAR(s.q[3], 0.6 * up, 1e-9);
}

TEST(ReadElements, UnknownElementIsRefusedByName) {
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"element 'drug' is not there", "drag"},
                            [] { read_mechanism("m", text + "[elements.air]\nkind = \"drug\"\n"); }));
}

TEST(ReadElements, KeyOfAnElementThatNobodyAsksForIsRefused) {
  EXPECT_THROW(read_mechanism(
                   "m", text + "[elements.air]\nkind = \"drag\"\npoint = \"B\"\ncoefficient = 1\narea = 2\n"),
               Error);
}

/// c |v| v on a mass of 1 kg: v = 1 / (1 / v0 + c t), what is lost is its power.
TEST(ReadElements, DragHasItsForceAndPower) {
  Mechanism m(
      read_mechanism("m",
                     "dimension = 2\n[points]\nP = { at = [0, 0], velocity = [3, 4] }\n"
                     "[masses.one]\npoint = \"P\"\nmass = 1\n[elements.air]\nkind = \"drag\"\npoint = \"P\"\n"
                     "coefficient = 0.5\n"));
  const State s = stands(m);
  double force[2];
  m.forces(s.q.data(), s.v.data(), force);
  EXPECT_DOUBLE_EQ(force[0], -7.5);
  EXPECT_DOUBLE_EQ(force[1], -10.0);
}

}  // namespace
}  // namespace tandem::mbs
