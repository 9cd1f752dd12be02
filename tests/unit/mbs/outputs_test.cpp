// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/outputs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "outputs_at_start.hpp"
#include "refusal.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;

const std::string rod_text =
    "dimension = 2\ngravity = [0, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\n";

/// A level rod that is let go: its tip falls with 3/2 g, the pin carries a quarter of its weight.
TEST(Outputs, OfARodThatIsLetGo) {
  const VectorXd y = outputs(rod_text +
                             "P = { at = [2, 0] }\n[rods]\nr = { points = ['O', 'P'], mass = 3 }\n[outputs]\n"
                             "x = { position = 'P.x' }\na = { acceleration = 'P.y' }\nrx = { reaction = "
                             "'O.x' }\nry = { reaction = 'O.y' }\n"
                             "e = { energy = 'total' }\n");
  EXPECT_EQ(y[0], 2.0);
  EXPECT_NEAR(y[1], -1.5 * 9.81, 1e-9);
  EXPECT_NEAR(y[2], 0.0, 1e-9);
  EXPECT_NEAR(y[3], 0.25 * 3 * 9.81, 1e-9);
  EXPECT_EQ(y[4], 0.0);
}

/// Turned by a motor at 2 rad/s and 3 rad/s^2: torque I alpha + m g l/2, and the pin carries what turns the
/// centre. (With a fixed point in place of the vector, the couple on the ground would be among the forces of
/// the two fixed points.)
TEST(Outputs, OfARodThatIsDriven) {
  const VectorXd y =
      outputs(rod_text +
              "P = { at = [2, 0] }\n[vectors]\nX = { at = [1, 0], fixed = true }\n[rods]\nr = { points = "
              "['O', 'P'], mass = 3 }\n"
              "[angles]\nt = { from = 'X', to = ['O', 'P'] }\n[inputs]\nu = { unit = 'rad', polynomial = [0, "
              "2, 1.5] }\n"
              "[drives]\nmotor = { coordinate = 't', motion = 'u' }\n[outputs]\nw = { velocity = 't' }\n"
              "a = { acceleration = 't' }\ntorque = { reaction = 'motor' }\nrx = { reaction = 'O.x' }\nry = "
              "{ reaction = 'O.y' }\n"
              "k = { energy = 'kinetic' }\n");
  EXPECT_NEAR(y[0], 2.0, 1e-10);
  EXPECT_NEAR(y[1], 3.0, 1e-9);
  EXPECT_NEAR(y[2], 3.0 * 4.0 / 3.0 * 3.0 + 3.0 * 9.81, 1e-6);
  EXPECT_NEAR(y[3], -3.0 * 4.0, 1e-6);
  EXPECT_NEAR(y[4], 3.0 * 3.0 + 3.0 * 9.81, 1e-6);
  EXPECT_NEAR(y[5], 0.5 * 4.0 * 4.0, 1e-9);
}

/// A mass on a spring that a force holds: both pull, and the anchor carries the spring.
TEST(Outputs, OfAMassBetweenASpringAndAForce) {
  const VectorXd y =
      outputs(rod_text +
              "P = { at = [1.5, 0] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
              "[springs]\ns = { points = ['O', 'P'], stiffness = [100, 40], free = 1 }\n"
              "[forces]\nf = { point = 'P', direction = [1, 1], magnitude = 12 }\n[outputs]\n"
              "ax = { acceleration = 'P.x' }\nay = { acceleration = 'P.y' }\nrx = { reaction = 'O.x' }\n"
              "v = { energy = 'potential' }\n");
  EXPECT_NEAR(y[0], (12.0 - 60.0) / 2.0, 1e-12);
  EXPECT_NEAR(y[1], 12.0 / 2.0 - 9.81, 1e-12);
  EXPECT_NEAR(y[2], -60.0, 1e-12);
  EXPECT_NEAR(y[3], 50.0 * 0.25 + 40.0 / 3.0 * 0.125, 1e-12);
}

/// Two rods of 1 m and 1 kg let go level: the first pushes the second with (0, -g/14) at the elbow, and is
/// pushed by as much; at the pin it bears what the support does.
TEST(Outputs, HaveWhatJointsDoToABody) {
  const VectorXd y =
      outputs(rod_text +
              "A = { at = [1, 0] }\nB = { at = [2, 0] }\n[rods]\nupper = { points = ['O', 'A'], mass = 1 }\n"
              "lower = { points = ['A', 'B'], mass = 1 }\n[outputs]\n"
              "x = { reaction = 'A.x', body = 'lower' }\ny = { reaction = 'A.y', body = 'lower' }\n"
              "up = { reaction = 'A.y', body = 'upper' }\nend = { reaction = 'B.y', body = 'lower' }\n"
              "pin = { reaction = 'O.y' }\nborne = { reaction = 'O.y', body = 'upper' }\n");
  EXPECT_NEAR(y[0], 0.0, 1e-9);
  EXPECT_NEAR(y[1], -9.81 / 14.0, 1e-9);
  EXPECT_NEAR(y[2], 9.81 / 14.0, 1e-9);
  EXPECT_NEAR(y[3], 0.0, 1e-9);
  EXPECT_NEAR(y[4], y[5], 1e-9);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"reaction", "body 'r'"}, [] {
    outputs(rod_text +
            "P = { at = [1, 0] }\nQ = { at = [1, 1] }\n[rods]\nr = { points = ['O', 'P'], mass = 1 }\n"
            "s = { points = ['O', 'Q'], mass = 1 }\n[outputs]\no = { reaction = 'Q.x', body = 'r' }\n");
  }));
}

TEST(Outputs, DependAtOnceOnWhatTheyShould) {
  Mechanism m(read_mechanism(
      "m", rod_text + "P = { at = [1.5, 0] }\nQ = { at = [1, 1] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
                      "[rods]\nr = { points = ['O', 'Q'], mass = 1 }\n[springs]\ns = { points = ['P', 'Q'], "
                      "stiffness = 1 }\n"
                      "[inputs]\nF = { unit = 'N' }\n"
                      "[forces]\nf = { point = 'P', direction = [1, 1], magnitude = 'F' }\n[outputs]\n"
                      "x = { position = 'P.x' }\nv = { velocity = 'P.x' }\na = { acceleration = 'P.x' }\n"
                      "r = { reaction = 'O.x' }\n"));
  const Outputs o(m);
  for (int output = 0; output < 4; ++output) {
    EXPECT_EQ(o.depends(output, 0), output == 2);
    EXPECT_EQ(o.derivatives(output), std::max(0, 2 - output));
  }
  EXPECT_EQ(o.unit(0), "m");
  EXPECT_EQ(o.unit(1), "m/s");
  EXPECT_EQ(o.unit(2), "m/s^2");
  EXPECT_EQ(o.unit(3), "N");
}

/// Two pendulums on one point, and a drive: a force on one is felt by its own acceleration and by the pin, at
/// once, and by nothing of the other.
TEST(Outputs, DependOnForcesAndDrivesOfWhatTheyAreConnectedWith) {
  Mechanism m(read_mechanism(
      "m", rod_text +
               "P = { at = [1, 0] }\nQ = { at = [0, 1] }\n[vectors]\nX = { at = [1, 0], fixed = true }\n"
               "[rods]\np = { points = ['O', 'P'], mass = 1 }\nq = { points = ['O', 'Q'], mass = 1 }\n"
               "[angles]\nt = { from = 'X', to = ['O', 'Q'] }\n"
               "[inputs]\nF = { unit = 'N' }\nu = { unit = 'rad' }\n"
               "[forces]\nf = { point = 'P', direction = [1, 1], magnitude = 'F' }\n"
               "[drives]\nd = { coordinate = 't', motion = 'u' }\n[outputs]\n"
               "pa = { acceleration = 'P.x' }\nqa = { acceleration = 'Q.x' }\nqx = { position = 'Q.x' }\n"
               "px = { position = 'P.x' }\npin = { reaction = 'O.y' }\ndrive = { reaction = 'd' }\n"
               "energy = { energy = 'drift' }\nmiss = { residual = 'acceleration' }\n"));
  const Outputs o(m);
  const std::vector<bool> on_force = {true, false, false, false, true, false, false, true},
                          on_drive = {false, true, true, false, true, true, true, true};
  for (int k = 0; k < o.size(); ++k) {
    EXPECT_EQ(o.depends(k, 0), on_force[static_cast<std::size_t>(k)]) << o.name(k);
    EXPECT_EQ(o.depends(k, 1), on_drive[static_cast<std::size_t>(k)]) << o.name(k);
  }
}

/// A base moves one mass by a spring, which moves another: the spring's force follows the base at once, where
/// the masses are does not.
TEST(Outputs, FollowADriveThroughASpringByAccelerationAlone) {
  const Mechanism m(read_mechanism(
      "m",
      rod_text +
          "B = { at = [1, 0] }\nP = { at = [2, 0] }\nQ = { at = [3, 0] }\nG = { at = [4, 0], fixed = true "
          "}\n[masses]\nb = { point = 'B', mass = 1 }\np = { point = 'P', mass = 1 }\n"
          "q = { point = 'Q', mass = 1 }\n[springs]\nob = { points = ['O', 'B'], stiffness = 1 }\n"
          "bp = { points = ['B', 'P'], stiffness = 1 }\npq = { points = ['P', 'Q'], stiffness = 1 }\n"
          "qg = { points = ['Q', 'G'], stiffness = 1 }\n[inputs]\nu = { unit = 'm' }\n[drives]\n"
          "d = { coordinate = 'B.x', motion = 'u' }\n[outputs]\nb = { position = 'B.x' }\n"
          "o = { reaction = 'O.x' }\np = { acceleration = 'P.x' }\nx = { position = 'P.x' }\n"
          "v = { velocity = 'P.x' }\nq = { acceleration = 'Q.x' }\ng = { reaction = 'G.x' }\n"));
  const Outputs o(m);
  const std::vector<bool> expected = {true, true, true, false, false, false, false};
  for (int k = 0; k < o.size(); ++k)
    EXPECT_EQ(o.depends(k, 0), expected[static_cast<std::size_t>(k)]) << o.name(k);
}

/// The axes of a point mass have nothing in common; of one on a rod they have.
TEST(Outputs, FollowAForceOnAPointMassByItsDirection) {
  const auto depend = [](const std::string& parts) {
    const Mechanism m(read_mechanism(
        "m",
        rod_text + "P = { at = [1, 0.5] }\n" + parts +
            "[inputs]\nF = { unit = 'N' }\n[forces]\nf = { point = 'P', direction = [0, 2], magnitude = 'F' "
            "}\n[outputs]\nx = { acceleration = 'P.x' }\ny = { acceleration = 'P.y' }\n"));
    const Outputs o(m);
    return std::pair(o.depends(0, 0), o.depends(1, 0));
  };
  EXPECT_EQ(depend("[masses]\nm = { point = 'P', mass = 1, free = true }\n"), std::pair(false, true));
  EXPECT_EQ(depend("[rods]\nr = { points = ['O', 'P'], mass = 1 }\n"), std::pair(true, true));
}

/// What happens to the outputs of a mass on a spring when the base stands elsewhere.
TEST(Outputs, ChangeAtOnceAsTheyDeclare) {
  const auto at = [](double u) {
    return outputs(
        rod_text +
        fmt::format(
            "B = {{ at = [1, 0] }}\nP = {{ at = [2, 0] }}\n[masses]\nb = {{ point = 'B', mass = 1 }}\n"
            "p = {{ point = 'P', mass = 2 }}\n[springs]\ns = {{ points = ['B', 'P'], stiffness = 7, "
            "free = 0.5 }}\n[inputs]\nu = {{ unit = 'm', value = {} }}\n[drives]\n"
            "d = {{ coordinate = 'B.x', motion = 'u' }}\n[initial]\npositions = {{ 'P.x' = 2, 'P.y' = 0 "
            "}}\n[outputs]\na = {{ acceleration = 'P.x' }}\nx = {{ position = 'P.x' }}\n",
            u));
  };
  EXPECT_NEAR(at(1.0)[0], -7.0 * 0.5 / 2.0, 1e-9);
  EXPECT_NEAR(at(1.2)[0], -7.0 * 0.3 / 2.0, 1e-9);
  EXPECT_EQ(at(1.0)[1], at(1.2)[1]);
}

/// A rod of 2 m that has become 1 mm too long and stretches: (|d|^2 - l^2)/l and its derivatives, and
/// the energy less that of the start.
TEST(Outputs, HaveResidualsAndTheDriftOfEnergy) {
  Mechanism m(read_mechanism("m", rod_text +
                                      "P = { at = [2, 0], velocity = [0, 3] }\n[rods]\nr = { points = ['O', "
                                      "'P'], mass = 3 }\n[outputs]\np = { residual = 'position' }\n"
                                      "v = { residual = 'velocity' }\na = { residual = 'acceleration' }\n"
                                      "d = { energy = 'drift' }\n"));
  State s = initial_state(m, 0.0);
  Index3(m, {}).start(s);
  Outputs o(m);
  o.start(s);
  VectorXd y(4);
  o.evaluate(s, y.data());
  EXPECT_LT(y.lpNorm<Eigen::Infinity>(), 1e-9);
  s.q[0] += 1e-3, s.v[0] += 0.5, s.a[0] += 0.25;
  const double length = s.q[0], v2 = s.v[0] * s.v[0] + s.v[1] * s.v[1];
  o.evaluate(s, y.data());
  EXPECT_NEAR(y[0], 0.5 * (length * length - 4.0), 1e-12);
  EXPECT_NEAR(y[1], length * s.v[0], 1e-12);
  EXPECT_NEAR(y[2], std::abs(length * s.a[0] + v2), 1e-12);
  EXPECT_NEAR(y[3], m.energy(s.q.data(), s.v.data()) - 0.5 * 9.0, 1e-12);
  EXPECT_EQ(o.unit(0), "1");
  EXPECT_EQ(o.unit(3), "J");
}

TEST(Outputs, TheReactionOnAFixedVectorIsACouple) {
  Mechanism m(read_mechanism("m",
                             "dimension = 3\n[points]\nO = { at = [0, 0, 0], fixed = true }\n[vectors]\na = "
                             "{ at = [1, 0, 0], fixed = true }\n"
                             "b = { at = [0, 1, 0] }\nc = { at = [0, 0, 1] }\n[bodies.B]\npoints = "
                             "['O']\nvectors = ['a', 'b', 'c']\n"
                             "mass = 1\ncentre = [0, 0, 0]\ninertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
                             "[outputs]\nr = { reaction = 'a.x' }\ns = { reaction = 'O.x' }\n"));
  EXPECT_EQ(Outputs(m).unit(0), "N m");
  EXPECT_EQ(Outputs(m).unit(1), "N");
}

}  // namespace
}  // namespace tandem::mbs
