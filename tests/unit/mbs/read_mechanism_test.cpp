// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "four_bar/linkage.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

TEST(ReadMechanism, ReadsTheLinkage) {
  const Description d = read_mechanism("f.toml", four_bar::text(3));
  EXPECT_EQ(d.name, "four_bar_3");
  EXPECT_EQ(d.dimension, 2);
  EXPECT_EQ(d.entities.size(), 8U);
  EXPECT_EQ(d.bodies.size(), 7U);
  const Mechanism m(d);
  EXPECT_EQ(m.structure().variables, 8);
  EXPECT_EQ(m.structure().constraints, 7);
  EXPECT_EQ(m.structure().variable_names[3], "B1.y");
  const State s = m.described_state();
  EXPECT_EQ(s.q[m.coordinate(2)], 2.0);
  EXPECT_EQ(s.v[m.coordinate(2)], 1.0);
}

TEST(ReadMechanism, TheLinkageInTheRepositoryIsTheOneOfTheBenchmark) {
  const auto file = std::filesystem::path(TANDEM_SOURCE_DIR) / "scenarios/mechanisms/four_bar/four_bar.toml";
  EXPECT_EQ(test::read_text(file), "#:schema ../../mechanism.schema.json\n" + four_bar::text(5));
  EXPECT_EQ(read_mechanism(file).bodies.size(), 11U);
}

TEST(ReadMechanism, TheMechanismOfTheDocumentIsOne) {
  std::string text = test::read_text(std::filesystem::path(TANDEM_SOURCE_DIR) / "docs/mechanisms.md");
  text = text.substr(text.find("```toml\n") + 8);
  Mechanism m(read_mechanism("mechanisms.md", text.substr(0, text.find("```"))));
  EXPECT_EQ(m.structure().variables, 6);
  EXPECT_EQ(m.structure().constraint_names,
            (std::vector<std::string>{"body arm: P . P", "body plate: Q . Q", "angle crank",
                                      "joint slide: across 1", "length reach"}));
  const State s = initial_state(m, 0.0);
  EXPECT_NEAR(s.v[m.numbering().relative[0]], 2.0, 1e-12);
}

/// What a line of a small mechanism says when it is changed: file, line, value found and allowed.
struct Bad {
  const char *from, *to;
  int line;
  std::vector<std::string> says;
};

constexpr const char* pendulum =
    "dimension = 2\n"
    "gravity = [0, -9.81]\n"
    "[points]\n"
    "O = { at = [0, 0], fixed = true }\n"
    "P = { at = [1, 0] }\n"
    "[rods]\n"
    "rod = { points = [\"O\", \"P\"], mass = 1 }\n"
    "[bodies.disc]\n"
    "points = [\"O\", \"P\"]\n"
    "mass = 2\n"
    "centre = [0.5, 0]\n"
    "inertia = 0.1\n";

TEST(ReadMechanism, RefusesWithFileLineValueAndWhatIsAllowed) {
  EXPECT_NO_THROW(read_mechanism("p.toml", pendulum));
  const Bad list[] = {
      {"dimension = 2", "dimension = 4", 1, {"dimension is 4", "2 for the plane, 3 for space"}},
      {"dimension = 2", "dimensoin = 2", 1, {"unknown key 'dimensoin'", "did you mean 'dimension'?"}},
      {"[0, -9.81]", "[0, 0, -9.81]", 2, {"gravity is an array of 3", "an array of 2 numbers"}},
      {"[0, -9.81]", "[0, 'g']", 2, {"gravity[1] is the text 'g'", "a number"}},
      {"at = [1, 0]", "to = [1, 0]", 5, {"points.P.at is missing", "points.P.at is missing"}},
      {"at = [1, 0]", "at = [0, 0]", 7, {"rods.rod.points are drawn at one place", "above 0 m"}},
      {"fixed = true", "fixed = true, velocity = [1, 0]", 4, {"points.O.velocity is not zero"}},
      {"[\"O\", \"P\"], mass", "[\"O\", \"Q\"], mass", 7, {"point 'Q' is not there", "There are: O, P"}},
      {"[\"O\", \"P\"], mass", "[\"O\", \"O\"], mass", 7, {"'O' twice"}},
      {"[\"O\", \"P\"], mass", "[\"O\"], mass", 7, {"1 names", "two points"}},
      {"mass = 1", "mass = -1", 7, {"rods.rod.mass is the number -1", "above 0"}},
      {"mass = 1", "mas = 1", 7, {"'mas'", "did you mean 'mass'?"}},
      {"inertia = 0.1", "inertia = 0", 12, {"bodies.disc.inertia", "above 0"}},
      {"centre = [0.5, 0]\n", "", 8, {"bodies.disc.centre is missing"}},
      {"[points]", "points = 3\n[other]", 3, {"points is the number 3", "a table"}},
      {"[bodies.disc]", "[bodies.rod]", 8, {"'rod' is there twice"}},
      {"inertia = 0.1", "inertia = 0.1\n[joints]\nj = 3", 14, {"joints.j is the number 3"}}};
  for (const Bad& bad : list) {
    std::string text = pendulum;
    text.replace(text.find(bad.from), std::string(bad.from).size(), bad.to);
    auto says = bad.says;
    says.push_back("p.toml:" + std::to_string(bad.line) + ": ");
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, says, [&] { read_mechanism("p.toml", text); }))
        << bad.to;
  }
}

/// The pendulum with more.
testing::AssertionResult refused(const std::string& more, const std::vector<std::string>& says) {
  return refuses(ErrorCode::invalid_argument, says,
                 [&] { Mechanism(read_mechanism("p.toml", pendulum + more)); });
}

testing::AssertionResult taken(const std::string& more) {
  try {
    Mechanism(read_mechanism("p.toml", pendulum + more));
  } catch (const Error& e) {
    return testing::AssertionFailure() << e.what();
  }
  return testing::AssertionSuccess();
}

/// The elements' own sentences.
TEST(ReadMechanism, RefusesElementsWithWhatIsAllowed) {
  EXPECT_TRUE(
      refused("[springs]\ns = { points = ['O', 'P'] }\n", {"p.toml:14", "springs.s.stiffness is missing"}));
  EXPECT_TRUE(refused("[springs]\ns = { coordinate = 'P.x', stiffness = 1 }\n",
                      {"one of a point", "an angle or a length"}));
  EXPECT_TRUE(refused("[springs]\ns = { coordinate = 'theta', stiffness = 1 }\n",
                      {"angle or length 'theta' is not there"}));
  EXPECT_TRUE(
      refused("[forces]\nf = { point = 'P', direction = [1, 0] }\n", {"forces.f.magnitude is missing"}));
  EXPECT_TRUE(refused("[forces]\nf = { point = 'P', direction = [1, 0], magnitude = 'F' }\n",
                      {"input 'F' is not there"}));
  EXPECT_TRUE(refused("[inputs]\nF = { value = 2 }\n", {"inputs.F.unit is missing"}));
  EXPECT_TRUE(
      refused("[inputs]\nF = { unit = 'N', value = 2, polynomial = [1] }\n", {"has 2 of value, polynomial"}));
  EXPECT_TRUE(refused("[outputs]\no = { position = 'P.x', velocity = 'P.x' }\n", {"names 2 quantities"}));
  EXPECT_TRUE(refused("[outputs]\no = { accelerance = 'P.x' }\n", {"input", "a force follows"}));
  EXPECT_TRUE(refused("[outputs]\no = { position = 'P.x', input = 'F' }\n", {"input", "it is no accelerance"}));
  EXPECT_TRUE(refused("[outputs]\no = { reaction = 'P.x' }\n", {"a point that is not fixed"}));
  EXPECT_TRUE(
      refused("[outputs]\no = { energy = 'all' }\n", {"'all'", "kinetic, potential, total or drift"}));
  EXPECT_TRUE(refused("[drives]\nd = { coordinate = 'O.x', motion = 'u' }\n", {"of a fixed point"}));
  EXPECT_TRUE(
      refused("[inputs]\nu = { unit = 'm', value = 1 }\n[drives]\nd = { coordinate = 'P.x', motion = 'u' }\n"
              "again = { coordinate = 'P.x', motion = 'u' }\n",
              {"drive 'again' moves what drive 'd' moves already", "one drive of a coordinate"}));
  EXPECT_TRUE(refused("[angles]\nt = { from = ['O', 'P'], to = ['O', 'P'] }\n",
                      {"angle 't' lies between an edge and itself", "two edges"}));
  EXPECT_TRUE(refused("[masses]\nm = { point = 'P', mass = -2 }\n", {"mass 'm' is -2 kg", "0 or more"}));
  EXPECT_TRUE(
      refused("[points.Q]\nat = [1, 1]\n", {"p.toml:13", "point 'Q' belongs to no body and has no mass"}));
  EXPECT_TRUE(refused(
      "[points.Q]\nat = [1, 1]\n[points.R]\nat = [2, 1]\n[rods.loose]\npoints = ['Q', 'R']\nmass = 1\n",
      {"p.toml:17", "body 'loose' is connected to nothing that is fixed"}));
  EXPECT_TRUE(refused("[fixed_angles]\na = { edges = ['u', ['O', 'P']] }\n", {"vector 'u' is not there"}));
  EXPECT_TRUE(refused("[fixed_angles]\na = { edges = [['O', 'P']] }\n", {"two edges"}));
  for (const char* table : {"[lengths]\n'P.x' = { points = ['O', 'P'] }\n",
                            "[angles]\n'P.x' = { from = ['O', 'P'], to = ['P', 'O'] }\n",
                            "[coordinates]\n'P.x' = { unit = 'm', inertia = 1 }\n"})
    EXPECT_TRUE(refused(table, {"p.toml:14: the name 'P.x' has a dot, as coordinates of points have"}));
  EXPECT_TRUE(refused("[lengths]\ns = { points = ['O', 'P'] }\n[relations]\nr = { terms = { s = 0 } }\n",
                      {"p.toml:16: relations.r.terms.s is 0; allowed is another factor"}));
  EXPECT_TRUE(refused("[lengths]\ns = { points = [] }\n", {"p.toml:14: lengths.s.points is 0 names"}));
}

TEST(ReadMechanism, RefusesWhatSaysNothing) {
  const std::string square = "allowed is a number above 0";
  EXPECT_TRUE(refused("[products]\np = { edges = [['O', 'P'], ['O', 'P']], value = 0 }\n",
                      {"p.toml:14: products.p.value is 0 m^2 of an edge with itself", square}));
  EXPECT_TRUE(refused("[products]\np = { edges = [['O', 'P'], ['P', 'O']], value = 1 }\n",
                      {"p.toml:14", "itself turned round", "below 0"}));
  EXPECT_TRUE(
      refused("[products]\np = { edges = [['P', 'P'], ['O', 'P']] }\n", {"p.toml:14", "from 'P' to itself"}));
  EXPECT_TRUE(refused("[distances]\nd = { points = ['O', 'P'], length = 1e-200 }\n",
                      {"p.toml:14: distances.d.length is 1e-200 m", "1e-100 to 1e100 m"}));
  EXPECT_TRUE(refused("[forces]\nf = { point = 'O', direction = [0, 1], magnitude = 1 }\n",
                      {"p.toml:14: forces.f.point is 'O', which is fixed"}));
  EXPECT_TRUE(refused("[forces]\nf = { point = 'P', direction = [0, 0], magnitude = 1 }\n",
                      {"p.toml:14: forces.f.direction is zero; allowed is a direction"}));
  EXPECT_TRUE(
      refused("[forces]\nf = { point = 'P', between = ['O', 'P'], direction = [0, 1], magnitude = 1 }\n",
              {"p.toml:14: force 'f' has point, between; allowed is one of point, between, coordinate"}));
  EXPECT_TRUE(
      refused("[forces]\nf = { magnitude = 1 }\n", {"p.toml:14", "one of point, between, coordinate"}));
  EXPECT_TRUE(refused("[inputs]\nF = { unit = 'N', value = 1 }\n",
                      {"p.toml:14: input 'F' is used by no force, drive or element"}));
  EXPECT_TRUE(refused("[inputs]\nF = { unit = 'N', polynomial = [] }\n",
                      {"p.toml:14: inputs.F.polynomial is an empty array"}));
  EXPECT_TRUE(refused("[springs]\ns = { points = ['O', 'P'], stiffness = [] }\n",
                      {"p.toml:14: springs.s.stiffness is an empty array"}));
}

TEST(ReadMechanism, RefusesNamesThatStandInTheWay) {
  EXPECT_TRUE(refused("[points.'']\nat = [0, 1]\n", {"p.toml:13: points has a name of no letters"}));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"p.toml:1", "name", "''", "one letter or more"},
                            [] { read_mechanism("p.toml", "name = ''\ndimension = 2\n"); }));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"p.toml:1", "'a b'", "blanks"},
                            [] { read_mechanism("p.toml", "name = 'a b'\ndimension = 2\n"); }));
  EXPECT_TRUE(refused("[points.'a,b']\nat = [0, 1]\n", {"p.toml:13: the name 'a,b' is no port's", "blanks"}));
  EXPECT_TRUE(refused("[bodies.b]\npoints = ['O', 'P', 'P']\n", {"p.toml:14: bodies.b.points is 'P' twice"}));
  EXPECT_TRUE(refused("[bodies.b]\npoints = ['O']\nvectors = ['P']\n",
                      {"p.toml:15: bodies.b.vectors is the point 'P'; allowed is the names of vectors"}));
  EXPECT_TRUE(
      refused("[outputs]\n'P.x' = { position = 'P.y' }\n", {"p.toml:14: output 'P.x' is not the position"}));
  EXPECT_TRUE(refused("[outputs]\n'O.x' = { energy = 'total' }\n", {"p.toml:14", "another name"}));
  EXPECT_TRUE(taken("[outputs]\n'P.x' = { position = 'P.x' }\n'P.z' = { energy = 'total' }\n"));
  EXPECT_TRUE(refused("[outputs]\no = { position = 'P.x', unit = 'm' }\n",
                      {"Allowed are: position, velocity, acceleration, reaction, body, energy"}));
}

TEST(ReadMechanism, RefusesAnInertiaThatIsZeroOrNotSymmetric) {
  const auto text = [](const std::string& inertia) {
    return "dimension = 3\n[points]\nO = { at = [0, 0, 0], fixed = true }\n[vectors]\na = { at = [1, 0, 0] "
           "}\n"
           "b = { at = [0, 1, 0] }\nc = { at = [0, 0, 1] }\n[bodies.B]\npoints = ['O']\nvectors = ['a', 'b', "
           "'c']\n"
           "mass = 1\ncentre = [0, 0, 0]\ninertia = " +
           inertia + "\n";
  };
  const auto says = [&](const std::string& inertia, const std::string& words) {
    return refuses(ErrorCode::invalid_argument, {words}, [&] { read_mechanism("m", text(inertia)); });
  };
  EXPECT_TRUE(
      says("[[0, 0, 0], [0, 0, 0], [0, 0, 0]]", "m:13: bodies.B.inertia is zero; allowed is that of a body"));
  EXPECT_TRUE(says("[[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]]",
                   "m:13: bodies.B.inertia is 0.1 in row 1, column 2, and 0.2 in row 2, column 1"));
  EXPECT_NO_THROW(read_mechanism("m", text("[[1, 0.1000000000000001, 0], [0.1, 1, 0], [0, 0, 1]]")));
}

}  // namespace
}  // namespace tandem::mbs
