// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/tyre_element.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "kart/rolling_tyre.hpp"
#include "tandem/error.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::kart {
namespace {

using mbs::Coordinate;
using mbs::ElementState;
using Vector = Eigen::Vector3d;
using In = Eigen::Map<const Vector>;
using Out = Eigen::Map<Vector>;

/// Coordinates: centre (0 to 2), axis (3 to 5), the spin (6) or both spokes (6 to 11), then the slips, then
/// with a brake the two points of the upright. Inputs: height of the ground, brake, as far as there are any.
class Tyre final : public mbs::ForceElement {
 public:
  struct Places {
    std::vector<Coordinate> coordinates;
    std::vector<int> inputs;
    bool spokes, lateral, ground, brake;
  };
  Tyre(const TyreData& data, Places places)
      : ForceElement(std::move(places.coordinates), std::move(places.inputs)),
        data_(data),
        spokes_(places.spokes),
        lateral_(places.lateral),
        ground_(places.ground),
        brake_(places.brake),
        state_(places.spokes ? 12 : 7),
        upright_(state_ + (places.lateral ? 2 : 1)) {}

  void add(const ElementState& at, double* force) const override {
    const Contact c = contact(at);
    const Vector axis = In(at.x + 3), down(0.0, 0.0, -c.height), along = c.force.longitudinal * c.along,
                 across = c.force.lateral * c.across,
                 couple = down.cross(across) - (c.resistance + c.brake) * axis +
                          (data_.lever == Lever::height ? down.cross(along)
                                                        : -data_.radius * c.force.longitudinal * axis);
    Out(force) += along + across + c.load * Vector::UnitZ();
    const auto turn = [&](int vector, double part) {
      Out to(force + vector);
      to += part * couple.cross(In(at.x + vector));
    };
    if (spokes_) {
      turn(3, 0.5), turn(6, 0.5), turn(9, 0.5);
    } else {
      turn(3, 1.0);
      force[6] += couple.dot(axis);
    }
    if (brake_) {
      Out(force + upright_) -= c.brake * c.lever;
      Out(force + upright_ + 3) += c.brake * c.lever;
    }
    force[state_] += data_.slip_rate(at.v[state_], c.sliding[0], c.speed);
    if (lateral_) force[state_ + 1] += data_.slip_rate(at.v[state_ + 1], c.sliding[1], c.speed);
  }

  /// With S the rates of s_x and s_y by those of the coordinates, forces are -S^T F (but with the printed
  /// lever); what turns with the wheel and what the load does to F is left out.
  void add_derivatives(const ElementState& at, Eigen::Ref<Eigen::MatrixXd> k,
                       Eigen::Ref<Eigen::MatrixXd> c) const override {
    const Contact now = contact(at);
    if (now.load > 0.0) k(2, 2) += data_.stiffness, c(2, 2) += data_.damping;
    const auto sliding = sliding_rates(at, now);
    const Eigen::Matrix2d slopes = data_.slopes(now.slip, now.load, now.force);
    const double damping = TyreData::damping_of_slip(now.speed);
    const int slips = upright_ - state_;
    for (int a = 0; a < slips; ++a) {
      c(state_ + a, state_ + a) += std::abs(now.speed) / data_.relaxation;
      for (int i = 0; i < state_; ++i) c(state_ + a, i) -= sliding(a, i) / data_.relaxation;
      for (int b = 0; b < slips; ++b)
        for (int i = 0; i < state_; ++i) {
          const double by = slopes(a, b) * sliding(a, i);
          c(i, state_ + b) += by;
          for (int j = 0; j < state_ && by != 0.0; ++j) c(i, j) += damping * by * sliding(b, j);
        }
    }
    const double braking = data_.resistance_rate(now.load, now.spin) / (data_.radius * data_.radius);
    for (int i = 6; i < state_; ++i)
      for (int j = 6; j < state_; ++j) c(i, j) += braking * sliding(0, i) * sliding(0, j);
    if (brake_ && now.biting != 0.0) add_brake_derivatives(now, sliding, c);
  }
  bool symmetric() const override { return true; }

  double potential(const double* x) const override { return data_.potential(x[2]); }

  std::vector<Quantity> quantities() const override {
    const bool presses = ground_ || brake_;
    return {{"load", "N", ground_},      {"excess", "N", ground_},       {"slip", "1"},
            {"side_slip", "1"},          {"drive", "N", ground_},        {"side", "N", ground_},
            {"slip_loss", "W", ground_}, {"rolling_loss", "W", ground_}, {"damping_loss", "W", ground_},
            {"brake_loss", "W", presses}};
  }
  void measure(const ElementState& at, double* values) const override {
    const Contact c = contact(at);
    const double all[] = {
        c.load,
        data_.excess(c.load),
        c.slip.longitudinal,
        c.slip.lateral,
        c.force.longitudinal,
        c.force.lateral,
        c.force.longitudinal * c.sliding[0] + c.force.lateral * c.sliding[1],
        c.resistance * c.spin,
        data_.damping_loss(c.height, at.v[2]),
        c.brake * c.turning,
    };
    std::copy(std::begin(all), std::end(all), values);
  }

 private:
  struct Contact {
    Vector along, across;  ///< e_x, e_y
    double tilt;           ///< 1 / cos of the camber
    double height, load, spin, speed;
    Eigen::Vector2d sliding;
    Slip slip;
    TyreForce force;
    double resistance;
    Vector lever;  ///< of the upright's edge: its turn about e is lever . (its difference of velocities)
    double turning, brake, biting;  ///< spin over the upright, couple against that, and its rate by it
  };

  double spin(const ElementState& at) const {
    if (!spokes_) return at.v[6];
    return 0.5 * (In(at.x + 9).dot(In(at.v + 6)) - In(at.x + 6).dot(In(at.v + 9)));
  }

  Contact contact(const ElementState& at) const {
    Contact c;
    const In axis(at.x + 3), velocity(at.v);
    c.along = axis.cross(Vector::UnitZ());
    c.tilt = 1.0 / c.along.norm();
    c.along *= c.tilt;
    c.across = Vector::UnitZ().cross(c.along);
    c.height = at.x[2] - (ground_ ? at.u[0] : 0.0);
    c.load = data_.load(c.height, at.v[2]);
    c.spin = spin(at);
    c.speed = velocity.dot(c.along);
    c.sliding << data_.radius * c.spin - c.speed, -velocity.dot(c.across) - c.height * c.tilt * at.v[5];
    c.slip.longitudinal = TyreData::slip(at.v[state_], c.sliding[0], c.speed);
    if (lateral_) c.slip.lateral = TyreData::slip(at.v[state_ + 1], c.sliding[1], c.speed);
    c.force = tyre_force(data_.law, data_.axle, c.slip, c.load);
    c.resistance = data_.resistance(c.load, c.spin);
    c.turning = c.brake = c.biting = 0.0;
    if (brake_) add_brake(at, c);
    return c;
  }

  /// Interpolation of a brake that is let go may end a rounding below zero.
  static constexpr double rounding = 1e-9;  // [N m]
  [[noreturn]] void refuse_brake(double applied) const {
    throw Error(
        ErrorCode::numerical,
        fmt::format("the brake of a {} wheel is {:.6g} N m; allowed is 0 or more (a brake holds either "
                    "way of turning; an input that is extrapolated can overshoot)",
                    data_.axle == Axle::front ? "front" : "rear", applied));
  }

  void add_brake(const ElementState& at, Contact& c) const {
    const In lower(at.x + upright_), upper(at.x + upright_ + 3), lower_rate(at.v + upright_),
        upper_rate(at.v + upright_ + 3);
    const Vector across = In(at.x + 3).cross(upper - lower);
    c.lever = across / across.squaredNorm();
    const double applied = at.u[ground_ ? 1 : 0];
    if (applied < -rounding) refuse_brake(applied);
    c.turning = c.spin - c.lever.dot(upper_rate - lower_rate);
    const double part = data_.gripping(c.turning);
    c.brake = applied * part;
    c.biting = applied * data_.gripping_rate(part);
  }

  void add_brake_derivatives(const Contact& now, const Eigen::Matrix<double, 2, 12>& sliding,
                             Eigen::Ref<Eigen::MatrixXd> c) const {
    Eigen::Matrix<double, 20, 1> turn = Eigen::Matrix<double, 20, 1>::Zero();
    for (int i = 6; i < state_; ++i) turn[i] = sliding(0, i) / data_.radius;
    turn.segment<3>(upright_) = now.lever;
    turn.segment<3>(upright_ + 3) = -now.lever;
    const auto n = static_cast<int>(c.rows());
    for (int i = 6; i < n; ++i)
      for (int j = 6; j < n; ++j) c(i, j) += now.biting * turn[i] * turn[j];
  }

  /// Of s_x and s_y by the rates of the coordinates.
  Eigen::Matrix<double, 2, 12> sliding_rates(const ElementState& at, const Contact& c) const {
    Eigen::Matrix<double, 2, 12> rates = Eigen::Matrix<double, 2, 12>::Zero();
    rates.block<1, 3>(0, 0) = -c.along.transpose();
    rates.block<1, 3>(1, 0) = -c.across.transpose();
    rates(1, 5) = -c.height * c.tilt;
    if (spokes_) {
      rates.block<1, 3>(0, 6) = 0.5 * data_.radius * In(at.x + 9).transpose();
      rates.block<1, 3>(0, 9) = -0.5 * data_.radius * In(at.x + 6).transpose();
    } else {
      rates(0, 6) = data_.radius;
    }
    return rates;
  }

  TyreData data_;
  bool spokes_, lateral_, ground_, brake_;
  int state_, upright_;  ///< where the slips and the upright's points begin
};

[[noreturn]] void refuse(mbs::ElementKeys& keys, const std::string& key, const std::string& why) {
  keys.at(key, [&] { throw Error(ErrorCode::invalid_argument, why); });
  throw Error(ErrorCode::internal, why);
}

/// The points that a brake reacts on.
void add_upright(mbs::ElementKeys& keys, std::vector<Coordinate>& coordinates) {
  const int lower = keys.point("lower"), upper = keys.point("upper");
  const Vector edge = keys.drawn(upper) - keys.drawn(lower);
  if (keys.drawn(keys.vector("axis")).cross(edge).norm() < 0.1 * edge.norm() || edge.norm() == 0.0)
    refuse(keys, "upper", "lower and upper lie along the axis; a brake needs points across from it");
  for (const int point : {lower, upper})
    for (const Coordinate& c : keys.axes(point)) coordinates.push_back(c);
}

}  // namespace

void keys_of_tyre(text::KeyList& to) {
  using enum text::Key::Type;
  to.need("centre", text, "The point at the wheel's centre.")
      .need("axis", text, "The vector along its axle, to the left, of length 1.")
      .may("spin", text, "The coordinate of its absolute spin, or")
      .may("spokes", texts, "two vectors that turn with it, with the axis a right-handed frame.")
      .may("lateral", flag, "It has a force across.", {.otherwise = "true"})
      .may("ground", text, "The input that is the height of the ground; without it 0.", {.unit = "m"})
      .may("brake", text, "The input that is the brake's couple, not below 0.", {.unit = "N m"})
      .may("lower", text, "With `brake`: a point of the upright that carries it, and")
      .may("upper", text, "another one, across from the axis.");
  TyreData::keys(to);
}

std::unique_ptr<mbs::ForceElement> make_tyre(mbs::ElementKeys& keys) {
  if (keys.dimension() != 3)
    refuse(keys, "kind", "a tyre needs dimension = 3; in the plane there is plane_tyres");
  Tyre::Places places{keys.axes(keys.point("centre")), {}, false, keys.flag("lateral"), false, false};
  const auto append = [&](int vector) {
    for (const Coordinate& c : keys.axes(vector)) places.coordinates.push_back(c);
  };
  append(keys.vector("axis"));
  places.spokes = keys.has("spokes");
  if (places.spokes) {
    keys.leave_out("spin", "spokes tell it");
    const auto spokes = keys.vectors("spokes");
    if (spokes.size() != 2) refuse(keys, "spokes", "spokes are not two vectors; allowed are two");
    append(spokes[0]);
    append(spokes[1]);
  } else {
    places.coordinates.push_back(keys.coordinate("spin"));
  }
  const TyreData data = TyreData::from(keys);
  const int ground = keys.input("ground", "m"), brake = keys.input("brake", "N m");
  places.ground = ground >= 0, places.brake = brake >= 0;
  for (const int input : {ground, brake})
    if (input >= 0) places.inputs.push_back(input);
  places.coordinates.push_back(keys.state("slip"));
  if (places.lateral) places.coordinates.push_back(keys.state("side_slip"));
  if (places.brake)
    add_upright(keys, places.coordinates);
  else
    for (const char* key : {"lower", "upper"}) keys.leave_out(key, "there is no brake");
  return std::make_unique<Tyre>(data, std::move(places));
}

mbs::ElementKinds element_kinds() {
  return {{"tyre", {"A wheel's tyre in space.", keys_of_tyre, make_tyre}},
          {"plane_tyres",
           {"The tyres of an axle's wheels in the plane.", keys_of_plane_tyres, make_plane_tyres}}};
}

}  // namespace tandem::kart
