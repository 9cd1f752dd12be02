// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/freedom.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "four_bar/linkage.hpp"
#include "refusal.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {
namespace {

TEST(Freedom, OfTheLinkageIsOneAndManyWhereItIsFlat) {
  for (const int loops : {1, 2, 5, 60}) {
    Mechanism linkage(read_mechanism("linkage", four_bar::text(loops)));
    State s = linkage.described_state();
    Freedom f = freedom(linkage, s);
    EXPECT_EQ(f.rank, 2 * loops + 1);
    EXPECT_EQ(f.degrees, 1);
    EXPECT_TRUE(f.redundant.empty());
    for (int i = 0; i <= loops; ++i) s.q.segment(2 * i, 2) << i + 1.0, 0.0;  // all rods in line
    f = freedom(linkage, s);
    EXPECT_EQ(f.rank, loops + 1) << "the couplers say nothing that the cranks do not";
    EXPECT_EQ(f.degrees, loops + 1);
    EXPECT_EQ(f.redundant.size(), static_cast<std::size_t>(loops));
  }
}

TEST(Freedom, NamesAConstraintThatIsThereTwice) {
  const std::string text =
      "dimension = 3\n"
      "[points]\nO = { at = [0, 0, 0], fixed = true }\nP = { at = [1, 0, 0] }\nQ = { at = [1, 2, 0] }\n"
      "[rods]\na = { points = ['O', 'P'], mass = 1 }\nb = { points = ['P', 'Q'], mass = 1 }\n"
      "[distances]\nagain = { points = ['Q', 'P'] }\n";
  Mechanism m(read_mechanism("twice", text));
  const Freedom f = freedom(m, m.described_state());
  EXPECT_EQ(f.rank, 2);
  EXPECT_EQ(f.degrees, 4);
  ASSERT_EQ(f.redundant.size(), 1U);
  const std::string name = m.structure().constraint_names[f.redundant[0]];
  EXPECT_TRUE(name == "distance again" || name == "body b: Q . Q") << name;
}

TEST(Freedom, OfABodyInSpaceIsSix) {
  const std::string text =
      "dimension = 3\n"
      "[points]\nO = { at = [0, 0, 0] }\n"
      "[vectors]\nx = { at = [1, 0, 0] }\ny = { at = [0, 1, 0] }\nz = { at = [0, 0, 1] }\n"
      "[bodies.box]\npoints = ['O']\nvectors = ['x', 'y', 'z']\nmass = 1\ncentre = [0.1, 0, 0]\n"
      "inertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
  Mechanism m(read_mechanism("box", text));
  EXPECT_EQ(m.structure().variables, 12);
  EXPECT_EQ(freedom(m, m.described_state()).degrees, 6);
}

/// Two bodies share P; a joint there holds nothing, but for what rounding leaves of it.
TEST(Freedom, IsNotTakenByAJointWhereThereIsOneAlready) {
  const std::string body = "mass = 1\ninertia = [[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]\n";
  const std::string text =
      "dimension = 3\n"
      "[points]\nO = { at = [0, 0, 0], fixed = true }\nP = { at = [1, 0, 0] }\nQ = { at = [2, 0, 0] }\n"
      "[vectors]\na = { at = [0, 1, 0] }\nb = { at = [0, 0, 1] }\nc = { at = [0, 1, 0] }\nd = { at = [0, 0, "
      "1] }\n"
      "[bodies.A]\npoints = ['O', 'P']\nvectors = ['a', 'b']\ncentre = [0.5, 0, 0]\n" +
      body + "[bodies.B]\npoints = ['P', 'Q']\nvectors = ['c', 'd']\ncentre = [1.5, 0, 0]\n" + body +
      "[joints.j]\nkind = 'spherical'\nbetween = ['A', 'B']\nat = [1, 0, 0]\n";
  Mechanism m(read_mechanism("two", text));
  const Freedom f = freedom(m, m.described_state());
  EXPECT_EQ(f.degrees, 6);
  ASSERT_EQ(f.redundant.size(), 3U);
  for (const int c : f.redundant) EXPECT_EQ(m.structure().constraint_names[c].substr(0, 7), "joint j");
}

TEST(RedundantEquations, AreRemarkedWhereAMechanismStandsSomewhere) {
  const auto rod = make_subsystem(
      read_mechanism("m",
                     "name = 'rod'\ndimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\n"
                     "P = { at = [1, 0] }\n[rods]\nr = { points = ['O', 'P'], mass = 1 }\n"
                     "[distances]\nd = { points = ['O', 'P'] }\n[outputs]\nx = { position = 'P.x' }\n"),
      {.step = 1e-3});
  EXPECT_TRUE(test::refuses(ErrorCode::wrong_state, {"mechanism 'rod'", "before initialize()"},
                            [&] { rod->remarks(1.0); }));
  std::vector<double> row(static_cast<std::size_t>(rod->info().row_size()));
  Samples y(row.data(), rod->info().row_size(), 1);
  rod->initialize(0.0, 1.0, {}, y);
  EXPECT_EQ(rod->remarks(1.0), std::vector<std::string>{"1 redundant equation: distance d"});
}

}  // namespace
}  // namespace tandem::mbs
