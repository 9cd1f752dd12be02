// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a joint lets go: degrees of freedom by rank, and rigid motions that it allows and forbids.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using Eigen::Vector3d;

const std::string box =
    "dimension = 3\n[points]\nA = { at = [1, 0.2, 0.1] }\n[vectors]\nu = { at = [1, 0, 0] }\nv = { at = [0, "
    "1, 0] }\n"
    "w = { at = [0, 0, 1] }\n[bodies.box]\npoints = ['A']\nvectors = ['u', 'v', 'w']\nmass = 2\ncentre = "
    "[1.2, 0.7, 0]\n"
    "inertia = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]\n";
const std::string bar =
    "dimension = 2\n[points]\nA = { at = [1, 0.2] }\nB = { at = [2, 0.3] }\n[bodies.bar]\npoints = ['A', "
    "'B']\nmass = 2\n"
    "centre = [1.2, 0.7]\ninertia = 1\n";

std::string joint(const std::string& kind, const std::string& rest) {
  return "[joints.j]\nkind = '" + kind + "'\n" + rest;
}

/// x -> at + R (x - at) + shift.
struct Motion3 {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vector3d at = Vector3d::Zero(), shift = Vector3d::Zero();
};

double violation(Mechanism& m, const Motion3& motion) {
  const Description& in = m.description();
  State s = m.described_state();
  for (std::size_t e = 0; e < in.entities.size(); ++e) {
    const Entity& entity = in.entities[e];
    const Vector3d to = entity.kind == Entity::Kind::vector
                            ? Vector3d(motion.turn * entity.at)
                            : Vector3d(motion.at + motion.turn * (entity.at - motion.at) + motion.shift);
    s.q.segment(m.coordinate(static_cast<int>(e)), in.dimension) = to.head(in.dimension);
  }
  Eigen::VectorXd phi(m.structure().constraints);
  std::vector<double> jacobian(static_cast<std::size_t>(m.structure().jacobian_values()));
  m.constraints(s.q.data(), phi.data(), jacobian.data());
  return phi.lpNorm<Eigen::Infinity>();
}

struct Allowed {
  const char* kind;
  int degrees;
  bool turns, slides, turns_across, slides_across;
};

const Vector3d at(1, 0.5, 0.2), axis(2, 1, 2), across(1, 0, -1);

TEST(Joint, InSpaceLeavesTheFreedomThatItShould) {
  const Allowed list[] = {
      {"revolute", 1, true, false, false, false},    {"prismatic", 1, false, true, false, false},
      {"cylindrical", 2, true, true, false, false},  {"spherical", 3, true, false, true, false},
      {"universal", 2, true, false, false, false},   {"point_on_line", 4, true, true, true, false},
      {"point_on_plane", 5, true, false, true, true}};
  for (const Allowed& a : list) {
    const std::string axes = a.kind == std::string("spherical") ? "" : "axis = [2, 1, 2]\n";
    const std::string second = a.kind == std::string("universal") ? "second_axis = [1, 0, -1]\n" : "";
    Mechanism m(read_mechanism(
        a.kind, box + joint(a.kind, "between = ['box', 'ground']\nat = [1, 0.5, 0.2]\n" + axes + second)));
    EXPECT_EQ(freedom(m, m.described_state()).degrees, a.degrees) << a.kind;
    const auto about = [](const Vector3d& n) {
      return Motion3{Eigen::AngleAxisd(0.3, n.normalized()).toRotationMatrix(), at};
    };
    const auto along = [](const Vector3d& n) { return Motion3{Eigen::Matrix3d::Identity(), at, 0.3 * n}; };
    const auto expect = [&](bool allowed, const Motion3& motion) {
      const double off = violation(m, motion);
      EXPECT_TRUE(allowed ? off < 1e-14 : off > 1e-3) << a.kind << " " << off;
    };
    expect(a.turns, about(axis));
    expect(a.slides, along(axis));
    expect(a.turns_across, about(Vector3d(0, 2, -1)));
    expect(a.slides_across, along(across));
  }
}

TEST(Joint, InThePlaneLeavesTheFreedomThatItShould) {
  for (const auto& [kind, degrees] : {std::pair{"revolute", 1}, {"prismatic", 1}, {"point_on_line", 2}}) {
    const std::string axes = kind == std::string("revolute") ? "" : "axis = [1, 3]\n";
    Mechanism m(read_mechanism(kind, bar + joint(kind, "between = ['bar', 'ground']\nat = [3, 2]\n" + axes)));
    EXPECT_EQ(freedom(m, m.described_state()).degrees, degrees) << kind;
    Motion3 turn{Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix(), {3, 2, 0}}, slide;
    slide.shift = {0.2, 0.6, 0};
    EXPECT_EQ(violation(m, turn) < 1e-14, kind != std::string("prismatic")) << kind;
    EXPECT_EQ(violation(m, slide) < 1e-14, kind != std::string("revolute")) << kind;
  }
}

TEST(Joint, RefusesWhatHasNoMeaning) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& says) {
    return test::refuses(ErrorCode::invalid_argument, says,
                         [&] { Mechanism(read_mechanism("m.toml", text)); });
  };
  const std::string rest = "between = ['box', 'ground']\nat = [1, 0.5, 0.2]\n";
  EXPECT_TRUE(refused(box + joint("revolut", rest), {"m.toml:15", "'revolut'", "did you mean 'revolute'?"}));
  EXPECT_TRUE(refused(box + joint("revolute", rest), {"joints.j.axis is missing"}));
  EXPECT_TRUE(refused(box + joint("revolute", rest + "axis = [0, 0, 0]\n"), {"'j'", "length 0"}));
  EXPECT_TRUE(refused(box + joint("universal", rest + "axis = [1, 0, 0]\nsecond_axis = [1, 1, 0]\n"),
                      {"not at a right angle"}));
  EXPECT_TRUE(refused(bar + joint("revolute", "between = ['bar', 'bar']\nat = [1, 0]\n"),
                      {"joins a carrier with itself", "allowed are two bodies"}));
  EXPECT_TRUE(refused(box + joint("spherical", "between = ['bxo', 'ground']\nat = [0, 0, 0]\n"),
                      {"'bxo'", "did you mean 'box'?"}));
  EXPECT_TRUE(
      refused(bar + joint("cylindrical", "between = ['bar', 'ground']\nat = [0, 0]\n"), {"'cylindrical'"}));
  EXPECT_TRUE(
      refused("dimension = 3\n[points]\nA = { at = [1, 0, 0] }\nB = { at = [2, 0, 0] }\n[rods]\n"
              "r = { points = ['A', 'B'], mass = 1 }\n" +
                  joint("spherical", "between = ['r', 'ground']\nat = [0, 1, 0]\n"),
              {"'r'", "(0, 1, 0)", "one more"}));
  EXPECT_TRUE(
      refused("dimension = 3\n[points]\nA = { at = [1e-9, 0, 0] }\nB = { at = [2e-9, 0, 0] }\n[rods]\n"
              "r = { points = ['A', 'B'], mass = 1 }\n" +
                  joint("spherical", "between = ['r', 'ground']\nat = [0, 1e-10, 0]\n"),
              {"'r'", "(0, 1e-10, 0)", "one more"}));
}

}  // namespace
}  // namespace tandem::mbs
