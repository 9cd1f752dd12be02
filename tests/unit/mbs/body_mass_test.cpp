// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/body_mass.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <random>

#include "refusal.hpp"

namespace tandem::mbs {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::refuses;

Vector3d random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  return {u(random), u(random), u(random)};
}

/// Kinetic energy of a rigid motion with velocity v of the origin and angular velocity w, from the entities'
/// velocities and from Koenig's theorem; and the power of a weight g.
void expect_rigid_motion(const Description& in, const Body& body, const Vector3d& v, const Vector3d& w) {
  const BodyMass share = body_mass(in, body);
  const int d = in.dimension;
  Eigen::VectorXd rates(d * static_cast<int>(share.entities.size()));
  for (std::size_t k = 0; k < share.entities.size(); ++k) {
    const Entity& e = in.entities[share.entities[k]];
    const Vector3d rate = (e.kind == Entity::Kind::point ? v : Vector3d(Vector3d::Zero())) + w.cross(e.at);
    rates.segment(d * static_cast<int>(k), d) = rate.head(d);
  }
  const Vector3d centre = v + w.cross(body.centre), g(0.3, -9.81, d == 3 ? 1.7 : 0.0);
  const double expected = 0.5 * body.mass * centre.squaredNorm() + 0.5 * w.dot(body.inertia * w);
  EXPECT_NEAR(0.5 * rates.dot(share.mass * rates), expected, 1e-12 * (1.0 + expected));
  EXPECT_NEAR(rates.dot(share.weight * g.head(d)), body.mass * centre.dot(g), 1e-11);
}

TEST(BodyMass, OfAUniformRodIsAThirdAndASixth) {
  Description in;
  in.entities = {{"A", Entity::Kind::point, false, {1, 2, 3}}, {"B", Entity::Kind::point, false, {4, -1, 2}}};
  const BodyMass m = body_mass(in, uniform_rod(in, "rod", 0, 1, 6.0));
  EXPECT_NEAR((m.mass - (Eigen::MatrixXd(6, 6) << 2.0 * Matrix3d::Identity(), 1.0 * Matrix3d::Identity(),
                         1.0 * Matrix3d::Identity(), 2.0 * Matrix3d::Identity())
                            .finished())
                  .norm(),
              0.0, 1e-13);
}

TEST(BodyMass, GivesTheEnergyOfAnyRigidMotionInSpace) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    Description in;
    const auto near = [&](const Vector3d& at) { return Vector3d(at + 0.2 * random_vector(random)); };
    for (const Vector3d& at : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
      in.entities.push_back({"P", Entity::Kind::point, false, near(at)});
    for (const Vector3d& at : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
      in.entities.push_back({"u", Entity::Kind::vector, false, near(at)});
    const Vector3d s = random_vector(random).cwiseAbs();  // second moments
    const Matrix3d axes = Eigen::AngleAxisd(1.0 + i, random_vector(random).normalized()).toRotationMatrix();
    const Matrix3d second = axes * s.asDiagonal() * axes.transpose();
    Body body{"b", {}, 2.5, random_vector(random), second.trace() * Matrix3d::Identity() - second};
    for (const auto& entities : {std::vector{0, 4, 5, 6}, {0, 1, 5, 6}, {0, 1, 2, 6}, {0, 1, 2, 3, 4}}) {
      body.entities = entities;
      expect_rigid_motion(in, body, random_vector(random), random_vector(random));
    }
  }
}

TEST(BodyMass, GivesTheEnergyOfAnyRigidMotionInThePlane) {
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    Description in;
    in.dimension = 2;
    for (const char* name : {"P", "Q", "R"}) {
      Vector3d at = random_vector(random);
      at[2] = 0.0;
      in.entities.push_back({name, Entity::Kind::point, false, at});
    }
    Body body{"b", {0, 1}, 1.5, random_vector(random), Matrix3d::Zero()};
    body.centre[2] = 0.0;
    body.inertia(2, 2) = 0.4 + 0.01 * i;
    Vector3d v = random_vector(random);
    v[2] = 0.0;
    expect_rigid_motion(in, body, v, {0, 0, 1.3});
    body.entities = {0, 1, 2};
    expect_rigid_motion(in, body, v, {0, 0, -0.7});
  }
}

TEST(BodyMass, ALaminaIsSpannedByThreePointsAndABoxIsNot) {
  Description in;
  in.entities = {{"P", Entity::Kind::point, false, {0, 0, 0}},
                 {"Q", Entity::Kind::point, false, {1, 0, 0}},
                 {"R", Entity::Kind::point, false, {0, 1, 0}}};
  const Body plate{"plate", {0, 1, 2}, 1.0, {0.3, 0.3, 0}, Vector3d(0.1, 0.2, 0.3).asDiagonal()};
  expect_rigid_motion(in, plate, {1, 2, 3}, {0.4, 0.5, 0.6});
  const Body box{"box", {0, 1, 2}, 1.0, {0.3, 0.3, 0}, Vector3d(0.2, 0.2, 0.2).asDiagonal()};
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'box'", "off the line or plane"}, [&] { body_mass(in, box); }));
}

/// Coefficients of points do not change where all lengths are s times as large and the body stands elsewhere.
/// A drawing has 16 digits, so that a body of 0.1 m that stands 1000 km away is known to 1e-9 of it.
TEST(BodyMass, IsTheSameOfABodyOfAnySizeAndPlace) {
  struct Case {
    double size;
    Vector3d place;
    double tolerance;
  };
  std::array<Eigen::MatrixXd, 2> all;  // as they are at the origin, by dimension
  const Vector3d away(1e6, -2e6, 0);
  for (const Case& c : {Case{1.0, Vector3d::Zero(), 0.0},
                        {1e-9, Vector3d::Zero(), 1e-12},
                        {1e90, Vector3d::Zero(), 1e-12},
                        {0.1, away, 1e-7}})
    for (const int dimension : {2, 3}) {
      Description in;
      in.dimension = dimension;
      for (const Vector3d& at :
           {Vector3d(0, 0, 0), Vector3d(1, 0.2, 0), Vector3d(0.3, 1, 0), Vector3d(0, 0.1, 1)})
        in.entities.push_back({"P", Entity::Kind::point, false, c.place + c.size * at});
      Body body{"b",
                {0, 1},
                2.0,
                c.place + c.size * Vector3d(0.2, 0.3, 0),
                c.size * c.size * Vector3d(0.4, 0.5, 0.6).asDiagonal().toDenseMatrix()};
      if (dimension == 3) body.entities = {0, 1, 2, 3};
      const BodyMass m = body_mass(in, body);
      Eigen::MatrixXd& expected = all[static_cast<std::size_t>(dimension - 2)];
      if (c.tolerance == 0.0) expected = m.mass;
      ASSERT_EQ(m.mass.rows(), expected.rows()) << c.size;
      EXPECT_LE((m.mass - expected).norm(), c.tolerance * m.mass.norm()) << c.size;
    }
}

TEST(BodyMass, OfASizeThatCanNotBeSquaredIsRefused) {
  Description in;
  in.dimension = 2;
  in.entities = {{"P", Entity::Kind::point, false, {0, 0, 0}},
                 {"Q", Entity::Kind::point, false, {1e200, 0, 0}}};
  Body body{"b", {0, 1}, 1.0, Vector3d::Zero(), Matrix3d::Identity()};
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'b'", "1e+200 m", "1e-100 to 1e100 m"},
                      [&] { body_mass(in, body); }));
}

/// The threshold is of the body, not of one metre.
TEST(BodyMass, SmallInertiaOffThePlaneOfASmallPlateIsRefused) {
  Description in;
  const double s = 1e-6;
  in.entities = {{"P", Entity::Kind::point, false, {0, 0, 0}},
                 {"Q", Entity::Kind::point, false, {s, 0, 0}},
                 {"R", Entity::Kind::point, false, {0, s, 0}}};
  const Body box{"box",
                 {0, 1, 2},
                 1.0,
                 {0.3 * s, 0.3 * s, 0},
                 s * s * Vector3d(0.2, 0.2, 0.2).asDiagonal().toDenseMatrix()};
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'box'", "off the line or plane"}, [&] { body_mass(in, box); }));
}

TEST(BodyMass, WhatNoBodyHasIsRefused) {
  Description in;
  in.entities = {{"P", Entity::Kind::point, false, {0, 0, 0}}, {"Q", Entity::Kind::point, false, {1, 0, 0}}};
  Body body = uniform_rod(in, "rod", 0, 1, -1.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'rod'", "mass of -1 kg"}, [&] { body_mass(in, body); }));
  body = uniform_rod(in, "rod", 0, 1, 1.0);
  body.inertia = Vector3d(1.0, 1.0, 5.0).asDiagonal();
  EXPECT_TRUE(refuses(
      ErrorCode::invalid_argument,
      {"'rod'",
       "no body has, with principal moments of 1, 1, 5 kg m^2; allowed is none below 0 and none above"},
      [&] { body_mass(in, body); }));
  in.entities[1].at = in.entities[0].at;
  body = uniform_rod(in, "rod", 0, 1, 1.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'rod'", "no two points"}, [&] { body_mass(in, body); }));
}

TEST(RigidConditions, AreThoseOfTheEdgesAndLeaveOutTheFixedOnes) {
  Description in;
  for (const auto& at : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 2, 0), Vector3d(0, 0, 3)})
    in.entities.push_back({"P" + std::to_string(in.entities.size()), Entity::Kind::point, false, at});
  const Body body{"b", {0, 1, 2, 3}, 1.0, {}, Matrix3d::Identity()};
  const auto all = rigid_conditions(in, body);
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[0].value, 1.0);
  EXPECT_EQ(all[1].value, 0.0);
  EXPECT_EQ(all[3].value, 4.0);
  EXPECT_EQ(all[5].value, 9.0);
  in.entities[0].fixed = in.entities[1].fixed = true;
  EXPECT_EQ(rigid_conditions(in, body).size(), 5U);
}

}  // namespace
}  // namespace tandem::mbs
