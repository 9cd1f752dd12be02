// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The kart in space steered, braked and on uneven ground: by statics, balances and the two-track formula.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "kart_run.hpp"

namespace tandem::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::array wheels = {"FL", "FR", "RL", "RR"};

/// Straight lines between (t, value).
std::function<double(double)> lines(std::vector<std::pair<double, double>> nodes) {
  return [nodes](double t) {
    if (t <= nodes.front().first) return nodes.front().second;
    for (std::size_t k = 1; k < nodes.size(); ++k)
      if (t < nodes[k].first) {
        const auto& [a, x] = nodes[k - 1];
        const auto& [b, y] = nodes[k];
        return x + (y - x) * (t - a) / (b - a);
      }
    return nodes.back().second;
  };
}

/// A motion from rest with this torque on the shaft [N m].
mbs::Description driven(const std::string& name, std::vector<std::pair<double, double>> torque) {
  mbs::Description d = kart(kart_text(name));
  set_input(d, "torque", lines(std::move(torque)));
  return d;
}

void go(KartRun& run, int steps) {
  for (int k = 0; k < steps; ++k) run.step();
}

/// Nothing but the height changes where the whole ground is 30 mm higher.
TEST(KartManoeuvre, StandsOnRaisedGroundAsOnLevelGround) {
  const KartRun level(kart(kart_text("spatial_scalar_spin")), 1e-3);
  KartRun raised(kart(kart_text("spatial_scalar_spin", {{"\"m\", value = 0 }", "\"m\", value = 0.03 }"}})),
                 1e-3);
  const double z = place(level.mechanism, level.state, "G")[2];
  EXPECT_NEAR(place(raised.mechanism, raised.state, "G")[2] - z, 0.03, 1e-8);
  for (const char* wheel : wheels)
    EXPECT_NEAR(raised.output(std::string("load_") + wheel), wheel[0] == 'F' ? 469.375 : 756.875, 0.01);
}

/// The load on the front axle goes by the moments about the ground, whatever brakes and uprights do to each
/// other: their couples are 86 N of its 160 N; as the nose dives the chassis goes forwards over its wheels.
/// Force at the ground: the brakes' couples over the radius; against it the mass with that of the spins, and
/// beside it air and rolling. Slips are nearly constant (0.5 % of the deceleration is what they, and tyres
/// that move on their track as the nose dives, may take).
TEST(KartManoeuvre, BrakesAsTheCouplesOfItsWheelsSay) {
  for (const char* name : {"spatial", "spatial_scalar_spin"}) {
    mbs::Description d = driven(name, {{0.0, 150.0}, {2.0, 150.0}, {2.1, 0.0}});
    set_input(d, "brake_front", lines({{2.2, 0.0}, {2.4, 30.0}}));
    set_input(d, "brake_rear", lines({{2.2, 0.0}, {2.4, 15.0}}));
    KartRun run(std::move(d), 1e-3);
    go(run, 2700);
    const double before = run.output("speed");
    go(run, 700);  // two periods of the pitch
    const double after = run.output("speed"), v = 0.5 * (before + after), r = 0.139;
    const double force = 2.0 * (30.0 + 15.0) / r + 0.42 * v * v + 0.02 * 250.0 * 9.81;
    const double a = (before - after) / 0.7;
    EXPECT_NEAR(a, force / (250.0 + 0.3 / (r * r)), 0.005 * force / 265.5) << name;
    const double moment = 250.0 * a * 0.25 + 0.3 * a / r - 0.42 * v * v * 0.274 - 0.02 * 250.0 * 9.81 * r;
    const auto x = [&](const char* point) { return place(run.mechanism, run.state, point)[0]; };
    const double axles = x("FL_C") - x("RL_C"), weight = 9.81 * (206.0 * (x("G") - x("RL_C")) + 18.0 * axles);
    EXPECT_NEAR(run.output("load_FL") + run.output("load_FR"), (weight + moment) / axles,
                0.03 * moment / axles)
        << name;
  }
}

/// What the brakes bring to a stand stays there.
TEST(KartManoeuvre, StandsWithItsBrakesOn) {
  mbs::Description d = driven("spatial_scalar_spin", {{0.0, 100.0}, {0.5, 100.0}, {0.6, 0.0}});
  set_input(d, "brake_front", lines({{0.7, 0.0}, {0.8, 50.0}}));
  KartRun run(std::move(d), 1e-3);
  go(run, 4000);
  EXPECT_NEAR(run.output("speed"), 0.0, 2e-3);
  EXPECT_NEAR(run.output("shaft_speed"), 0.0, 0.05);
}

/// What is known of the kart's rigid body for the formula.
struct TwoTrack {
  double speed;                    ///< [m/s]
  std::array<double, 4> angles;    ///< of the wheels' planes to the chassis [rad]
  std::array<Vector2d, 4> places;  ///< of the wheels, from the centre of mass [m]

  /// Static loads, and what roll and roll centres shift at a lateral acceleration: the roll moment of the
  /// sprung mass about its roll centres (9 mm high) goes by roll stiffness (wheel rates with those of the
  /// tyres in series, 5222 and 6379 N/m), its force at the roll centres by the distance of the axles, that of
  /// the wheels direct.
  std::array<double, 4> loads(double a) const {
    const double front = 0.5 * 5222.0 * 1.055 * 1.055, rear = 0.5 * 6379.0 * 1.2 * 1.2,
                 height = 0.2737 - 0.009, moment = 206.0 * a * height,
                 roll = moment / (front + rear - 206.0 * 9.81 * height),
                 f = (front * roll + 206.0 * a * 0.3941 / 1.045 * 0.009 + 18.0 * a * 0.139) / 1.055,
                 r = (rear * roll + 206.0 * a * 0.6509 / 1.045 * 0.009 + 26.0 * a * 0.139) / 1.2;
    return {469.4 - f, 469.4 + f, 756.9 - r, 756.9 + r};
  }

  /// Force across and moment about the centre of mass, less what the turn takes; x: drift angle, yaw rate.
  Vector2d balance(const Vector2d& x) const {
    const Vector2d v(speed * std::cos(x[0]), speed * std::sin(x[0]));
    const auto load = loads(speed * x[1]);
    Vector2d sum(-250.0 * v[0] * x[1], 0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector2d at(v[0] - x[1] * places[i][1], v[1] + x[1] * places[i][0]);
      const double c = std::cos(angles[i]), s = std::sin(angles[i]);
      const kart::Slip slip{0.0, -(at[1] * c - at[0] * s) / (at[0] * c + at[1] * s)};
      const double force = kart::tyre_force(kart::TyreLaw::magic_formula,
                                            i < 2 ? kart::Axle::front : kart::Axle::rear, slip, load[i])
                               .lateral;
      sum += Vector2d(force * c, force * (places[i][0] * c + places[i][1] * s));
    }
    return sum;
  }
  double yaw_rate() const {
    Vector2d x(0.0, 0.1);
    for (int k = 0; k < 20; ++k) {
      Eigen::Matrix2d j;
      for (int c = 0; c < 2; ++c)
        j.col(c) = (balance(x + 1e-6 * Vector2d::Unit(c)) - balance(x - 1e-6 * Vector2d::Unit(c))) / 2e-6;
      x -= j.fullPivLu().solve(balance(x));
    }
    return x[1];
  }
};

/// From 2.5 to 3.5 s, without a kink, with the derivatives that a drive needs.
void steer(mbs::Description& d, double angle) {
  for (mbs::Input& input : d.inputs)
    if (input.name == "steering")
      input.function = [angle](double t) {
        const double s = std::clamp(t - 2.5, 0.0, 1.0);
        const bool moves = s > 0.0 && s < 1.0;
        return mbs::InputValue{angle * s * s * (3.0 - 2.0 * s), angle * 6.0 * s * (1.0 - s),
                               moves ? angle * (6.0 - 12.0 * s) : 0.0};
      };
}

TwoTrack seen_from_above(const KartRun& run) {
  const auto at = [&](const std::string& name) { return place(run.mechanism, run.state, name); };
  const Vector3d x = at("cx"), y = at("cy"), g = at("G");
  TwoTrack t{};
  t.speed = run.state.v.segment<2>(run.mechanism.coordinate(entity(run.mechanism, "G"))).norm();
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const Vector3d e = at(std::string("e_") + wheels[i]), c = at(std::string(wheels[i]) + "_C") - g;
    t.angles[i] = std::atan2(-e.dot(x), e.dot(y));
    t.places[i] = {c.dot(x) - 0.00584, c.dot(y)};  // G is behind the centre of the whole
  }
  return t;
}

/// Steady: after 2.5 s, 5 periods of the yaw's swing. The formula leaves out drive, camber and its load's
/// change with the drag: 2 % of the yaw rate, 3 % of the loads.
TEST(KartManoeuvre, CornersAsTheTwoTrackFormulaSays) {
  for (const double steering : {0.1, 0.3}) {
    mbs::Description d = driven("spatial_scalar_spin", {{0.0, 150.0}, {2.4, 150.0}, {2.5, 12.0}});
    steer(d, steering);
    KartRun run(std::move(d), 2e-3);
    go(run, 2500);
    const double before = run.output("yaw");
    run.step();
    const double rate = (run.output("yaw") - before) / 2e-3;
    const TwoTrack formula = seen_from_above(run);
    EXPECT_NEAR(rate, formula.yaw_rate(), 0.02 * rate) << steering;
    EXPECT_GT(rate * formula.speed, steering == 0.1 ? 1.0 : 3.0);  // [m/s^2]: a turn worth the name
    const auto loads = formula.loads(rate * formula.speed);
    for (std::size_t i = 0; i < wheels.size(); ++i)
      EXPECT_NEAR(run.output(std::string("load_") + wheels[i]), loads[i], 0.03 * loads[i]) << wheels[i];
  }
}

}  // namespace
}  // namespace tandem::test
