// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The kart in space where it stands: its size, rank, mass, loads, modes and kinematics.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "kart_run.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/modes.hpp"

namespace tandem::test {
namespace {

using Eigen::Vector3d;
using mbs::Mechanism;

const char* const corners[] = {"FL", "FR", "RL", "RR"};

/// 163 coordinates and 148 equations, 139 and 124 with scalar spins, without the slips and the steering's
/// drive.
TEST(KartSpatial, HasTheVariablesAndEquationsOfTheSpecification) {
  for (const auto& [name, variables, equations] :
       {std::tuple("spatial", 163, 148), {"spatial_scalar_spin", 139, 124}}) {
    const Mechanism m(kart(kart_text(name)));
    EXPECT_EQ(m.structure().variables - static_cast<int>(m.structure().states.size()), variables);
    EXPECT_EQ(m.structure().states.size(), 8U);
    EXPECT_EQ(m.structure().constraints, equations + 1);
  }
}

/// The chassis stands, front left and rear right are up by `travel`, the others down; steering [rad].
mbs::Description posed(const std::string& name, double travel, double steering, double spin) {
  mbs::Description d = kart(kart_text(name));
  d.equilibrium = false;
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e) {
    const auto& entity = d.entities[static_cast<std::size_t>(e)];
    const bool chassis =
        entity.name == "G" || entity.name == "cx" || entity.name == "cy" || entity.name == "cz";
    for (int axis = 0; axis < 3 && chassis; ++axis) d.positions.push_back({{e, axis}, entity.at[axis]});
    if (entity.name == "FL_C" || entity.name == "RR_C")
      d.positions.push_back({{e, 2}, entity.at[2] + travel});
    if (entity.name == "FR_C" || entity.name == "RL_C")
      d.positions.push_back({{e, 2}, entity.at[2] - travel});
  }
  for (int r = 0; r < static_cast<int>(d.relatives.size()); ++r)
    if (d.relatives[static_cast<std::size_t>(r)].name.starts_with("spin_"))
      d.positions.push_back({{-1, 0, r}, spin * (1.0 + 0.1 * r)});
  set_input(d, "steering", [steering](double) { return steering; });
  return d;
}

TEST(KartSpatial, EquationsAreIndependentOverTheRangeOfPoses) {
  for (const char* name : {"spatial", "spatial_scalar_spin"})
    for (const double travel : {-0.04, 0.0, 0.04})
      for (const double steering : {-2.5, 0.0, 2.5})
        for (const double spin : {0.0, 1.3, 4.0}) {
          Mechanism m(posed(name, travel, steering, spin));
          const mbs::State s = mbs::initial_state(m, 0.0);
          const mbs::Freedom freedom = mbs::freedom(m, s);
          EXPECT_EQ(freedom.rank, m.structure().constraints) << name << travel << steering << spin;
          EXPECT_EQ(freedom.degrees, 14 + 8);
        }
}

/// As a whole: 250 kg, its centre 0.25 m over the origin, to the digits of the printed centre of the chassis.
TEST(KartSpatial, HasItsMassAndCentre) {
  for (const char* name : {"spatial", "spatial_scalar_spin"}) {
    const Mechanism m(kart(kart_text(name)));
    const mbs::State s = m.described_state();
    double mass = 0.0;
    Vector3d moment = Vector3d::Zero();
    for (const auto& body : m.description().bodies) mass += body.mass, moment += body.mass * body.centre;
    for (const auto& point : m.description().masses) {
      mass += point.mass;
      moment += point.mass * m.description().entities[static_cast<std::size_t>(point.point)].at;
    }
    EXPECT_NEAR(mass, 250.0, 1e-10);
    EXPECT_NEAR((moment / mass - Vector3d(0.0, 0.0, 0.25)).norm(), 0.0, 2e-5);
    // The mass matrix says the same: the energy of a translation and the work of weight.
    Eigen::VectorXd v = Eigen::VectorXd::Zero(m.structure().coordinates);
    for (std::size_t e = 0; e < m.description().entities.size(); ++e)
      if (m.description().entities[e].kind == mbs::Entity::Kind::point)
        v.segment<3>(m.coordinate(static_cast<int>(e))) << 1.0, 2.0, 3.0;
    EXPECT_NEAR(m.kinetic(v.data()), 0.5 * 250.0 * 14.0, 1e-8);
  }
}

/// Printed: 469.38 and 756.87 N, springs of 0.304179 and 0.324423 m, whose free lengths have five digits:
/// 1e-5 m of 13.5 kN/m with a motion ratio of 0.63 sink the kart by 1e-5 m.
TEST(KartSpatial, StandsOnItsSpringsAsPrinted) {
  for (const char* name : {"spatial", "spatial_scalar_spin"}) {
    KartRun run(kart(kart_text(name)), 1e-3);
    for (const char* corner : corners) {
      const bool front = corner[0] == 'F';
      EXPECT_NEAR(run.output(std::string("load_") + corner), front ? 469.38 : 756.87, 0.01);
    }
    const auto& d = run.mechanism.description();
    for (std::size_t r = 0; r < d.relatives.size(); ++r)
      if (d.relatives[r].name.starts_with("spring_")) {
        EXPECT_NEAR(run.state.q[run.mechanism.numbering().relative[r]],
                    d.relatives[r].name[7] == 'F' ? 0.304179 : 0.324423, 1e-5);
      }
    EXPECT_LT(run.state.a.cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(run.output("residual"), 1e-10);
  }
}

/// It stands still on ground that is not level, and carries the same weight; a wheel that is up is loaded,
/// and so is the one across from it. A torque, here 5 N m that nothing balances, begins to act at the start.
TEST(KartSpatial, StandsOnTheGroundAsItIsAtTheStart) {
  for (const char* name : {"spatial", "spatial_scalar_spin"}) {
    mbs::Description d = kart(kart_text(name));
    set_input(d, "ground_FL", [](double) { return 0.01; });
    KartRun still(d, 1e-3);
    EXPECT_LT(still.state.a.cwiseAbs().maxCoeff(), 1e-6) << name;
    double weight = 0.0;
    for (const char* corner : corners) weight += still.output(std::string("load_") + corner);
    EXPECT_NEAR(weight, 250.0 * 9.81, 1e-3);
    EXPECT_GT(still.output("load_FL"), still.output("load_FR") + 20.0);
    EXPECT_GT(still.output("load_RR"), still.output("load_RL") + 20.0);

    set_input(d, "torque", [](double) { return 5.0; });
    KartRun driven(d, 1e-3);
    EXPECT_NEAR(driven.output("load_FL"), still.output("load_FL"), 1e-6);
    EXPECT_GT(driven.state.a.cwiseAbs().maxCoeff(), 1.0);
  }
}

/// Printed heave 1.654 Hz / 0.134, pitch 2.793 / 0.239, roll 2.722 / 0.229, hop 12.09 and 14.80 Hz, without
/// forces along the ground. Here tyres hold the wheels as they swing at rest: pitch is 0.5 % lower, as it is
/// with tyres that have no longitudinal force at all (2.780 Hz, 0.238).
TEST(KartSpatial, SwingsAsPrinted) {
  for (const char* name : {"spatial", "spatial_scalar_spin"}) {
    Mechanism m(kart(kart_text(name, without_lateral)));
    const auto all = mbs::modes(m, mbs::initial_state(m, 0.0));
    const auto find = [&](const std::string& word) {
      for (const mbs::Mode& mode : all)
        if (mode.oscillates() && name_of(m, mode) == word) return mode;
      ADD_FAILURE() << word;
      return all[0];
    };
    EXPECT_NEAR(find("heave").frequency(), 1.654, 1e-3);
    EXPECT_NEAR(find("heave").damping(), 0.134, 1e-3);
    EXPECT_NEAR(find("roll").frequency(), 2.722, 5e-3);
    EXPECT_NEAR(find("roll").damping(), 0.229, 1e-3);
    EXPECT_NEAR(find("pitch").frequency(), 2.793, 0.015);
    EXPECT_NEAR(find("pitch").damping(), 0.239, 0.008);
    int hops = 0;
    for (const mbs::Mode& mode : all)
      if (mode.oscillates() && shares(m, mode)[0].name.ends_with("along z") && mode.frequency() > 5.0) {
        EXPECT_NEAR(mode.frequency(), mode.frequency() < 13.0 ? 12.09 : 14.80, 0.025);
        ++hops;
      }
    EXPECT_EQ(hops, 4);
  }
}

/// One corner by itself: balls L, U and T of the front left knuckle with the arms' pivots, the rack end and
/// the knuckle's own lengths, C and e as combinations of three of its edges; Newton's method with
/// differences.
class Corner {
 public:
  explicit Corner(double height) : x_(9) {
    x_ << 0.648, 0.455, 0.085, 0.640, 0.445, 0.195, 0.575, 0.455, 0.105;
    start_ = x_;
    for (int k = 0; k < 30; ++k) {
      const Eigen::VectorXd f = errors(x_, height);
      Eigen::MatrixXd j(9, 9);
      for (int c = 0; c < 9; ++c) {
        Eigen::VectorXd plus = x_, minus = x_;
        plus[c] += 1e-6, minus[c] -= 1e-6;
        j.col(c) = (errors(plus, height) - errors(minus, height)) / 2e-6;
      }
      x_ -= j.partialPivLu().solve(f);
    }
  }
  Vector3d centre() const { return carried(x_, Vector3d(0.645, 0.5275, 0.139) - start_.head<3>(), true); }
  Vector3d axis() const { return carried(x_, Vector3d::UnitY(), false); }

 private:
  static Eigen::Matrix3d frame(const Eigen::VectorXd& x) {
    Eigen::Matrix3d f;
    f.col(0) = x.segment<3>(3) - x.head<3>();
    f.col(1) = x.tail<3>() - x.head<3>();
    f.col(2) = f.col(0).cross(f.col(1));
    return f;
  }
  Vector3d carried(const Eigen::VectorXd& x, const Vector3d& drawn, bool from_lower) const {
    const Vector3d moved = frame(x) * frame(start_).inverse() * drawn;
    return from_lower ? Vector3d(x.head<3>() + moved) : moved;
  }
  Eigen::VectorXd errors(const Eigen::VectorXd& x, double height) const {
    const Vector3d pivots[] = {{0.72, 0.20, 0.085},
                               {0.57, 0.20, 0.085},
                               {0.70, 0.23, 0.190},
                               {0.58, 0.23, 0.190},
                               {0.575, 0.205, 0.103}};
    const int ball[] = {0, 0, 3, 3, 6};
    Eigen::VectorXd f(9);
    for (int k = 0; k < 5; ++k)
      f[k] = (x.segment<3>(ball[k]) - pivots[k]).norm() - (start_.segment<3>(ball[k]) - pivots[k]).norm();
    const int pairs[][2] = {{0, 3}, {0, 6}, {3, 6}};
    for (int k = 0; k < 3; ++k)
      f[5 + k] = (x.segment<3>(pairs[k][0]) - x.segment<3>(pairs[k][1])).norm() -
                 (start_.segment<3>(pairs[k][0]) - start_.segment<3>(pairs[k][1])).norm();
    f[8] = carried(x, Vector3d(0.645, 0.5275, 0.139) - start_.head<3>(), true)[2] - height;
    return f;
  }
  Eigen::VectorXd x_, start_;
};

TEST(KartSpatial, CornerPushedUpMovesAsItsArmsSay) {
  for (const double travel : {0.02, -0.03}) {
    Mechanism m(posed("spatial", travel, 0.0, 0.0));
    const mbs::State s = mbs::initial_state(m, 0.0);
    const Corner alone(0.139 + travel);
    const Vector3d c = place(m, s, "FL_C"), e = place(m, s, "e_FL");
    EXPECT_LT((c - alone.centre()).norm(), 1e-8);  // track
    EXPECT_LT((e - alone.axis()).norm(), 1e-8);    // camber and toe
    EXPECT_GT((e - Vector3d::UnitY()).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace tandem::test
