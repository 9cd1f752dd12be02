// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>

#include "kart/rolling_tyre.hpp"
#include "kart/tyre_element.hpp"
#include "tandem/error.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::kart {
namespace {

using mbs::ElementState;
using PlaneVector = Eigen::Vector2d;
using PlaneIn = Eigen::Map<const PlaneVector>;

PlaneVector turned(const PlaneVector& v) { return {-v[1], v[0]}; }  // a quarter turn counterclockwise

/// Coordinates: centre (0, 1), rim (2, 3), the slip. Forwards rolling is clockwise.
class PlaneTyres final : public mbs::ForceElement {
 public:
  PlaneTyres(const TyreData& data, std::vector<mbs::Coordinate> coordinates)
      : ForceElement(std::move(coordinates), {}), data_(data) {}

  void add(const ElementState& at, double* force) const override {
    const Contact c = contact(at);
    const double lever = data_.lever == Lever::height ? c.height : data_.radius,
                 couple = 2.0 * (lever * c.force + c.resistance);  // counterclockwise
    const PlaneVector pair = couple / c.spoke.squaredNorm() * turned(c.spoke);
    force[0] += 2.0 * c.force - pair[0];
    force[1] += 2.0 * c.load - pair[1];
    force[2] += pair[0];
    force[3] += pair[1];
    force[4] += data_.slip_rate(at.v[4], c.sliding, at.v[0]);
  }

  /// As Tyre's.
  void add_derivatives(const ElementState& at, Eigen::Ref<Eigen::MatrixXd> k,
                       Eigen::Ref<Eigen::MatrixXd> c) const override {
    const Contact now = contact(at);
    if (now.load > 0.0) k(1, 1) += 2.0 * data_.stiffness, c(1, 1) += 2.0 * data_.damping;
    const PlaneVector spin = -turned(now.spoke) / now.spoke.squaredNorm();  // by the rim's velocity
    Eigen::Matrix<double, 1, 5> turns, sliding;
    turns << -spin.transpose(), spin.transpose(), 0.0;
    sliding = data_.radius * turns;
    sliding[0] -= 1.0;
    const double slope = 2.0 * data_.slopes(now.slip, now.load, {now.force, 0.0})(0, 0);
    c.noalias() += slope * TyreData::damping_of_slip(at.v[0]) * sliding.transpose() * sliding;
    c.noalias() += 2.0 * data_.resistance_rate(now.load, now.spin) * turns.transpose() * turns;
    c.col(4) += slope * sliding.transpose();
    c.row(4) -= sliding / data_.relaxation;
    c(4, 4) += std::abs(at.v[0]) / data_.relaxation;
  }

  bool symmetric() const override { return true; }

  double potential(const double* x) const override { return 2.0 * data_.potential(x[1]); }

  std::vector<Quantity> quantities() const override {
    return {{"load", "N"},     {"excess", "N"},    {"slip", "1"},         {"drive", "N"},
            {"spin", "rad/s"}, {"slip_loss", "W"}, {"rolling_loss", "W"}, {"damping_loss", "W"}};
  }
  void measure(const ElementState& at, double* values) const override {
    const Contact c = contact(at);
    const double all[] = {
        c.load, data_.excess(c.load), c.slip.longitudinal,   c.force,
        c.spin, c.force * c.sliding,  c.resistance * c.spin, data_.damping_loss(c.height, at.v[1])};
    std::copy(std::begin(all), std::end(all), values);
  }

 private:
  struct Contact {
    PlaneVector spoke;
    double height, load, spin, sliding;
    Slip slip;
    double force, resistance;
  };
  Contact contact(const ElementState& at) const {
    Contact c{};
    const PlaneVector rate = PlaneIn(at.v + 2) - PlaneIn(at.v);
    c.spoke = PlaneIn(at.x + 2) - PlaneIn(at.x);
    c.height = at.x[1];
    c.load = data_.load(c.height, at.v[1]);
    c.spin = -turned(c.spoke).dot(rate) / c.spoke.squaredNorm();
    c.sliding = data_.radius * c.spin - at.v[0];
    c.slip.longitudinal = TyreData::slip(at.v[4], c.sliding, at.v[0]);
    c.force = tyre_force(data_.law, data_.axle, c.slip, c.load).longitudinal;
    c.resistance = data_.resistance(c.load, c.spin);
    return c;
  }
  TyreData data_;
};

}  // namespace

void keys_of_plane_tyres(text::KeyList& to) {
  using enum text::Key::Type;
  to.need("centre", text, "The point at the wheels' centre.").need("rim", text, "A point of their body.");
  TyreData::keys(to);
}

std::unique_ptr<mbs::ForceElement> make_plane_tyres(mbs::ElementKeys& keys) {
  if (keys.dimension() != 2)
    keys.at("kind", [] {
      throw Error(ErrorCode::invalid_argument, "plane_tyres need dimension = 2; in space there is tyre");
    });
  auto coordinates = keys.axes(keys.point("centre"));
  for (const mbs::Coordinate& c : keys.axes(keys.point("rim"))) coordinates.push_back(c);
  const TyreData data = TyreData::from(keys);
  coordinates.push_back(keys.state("slip"));
  return std::make_unique<PlaneTyres>(data, std::move(coordinates));
}

}  // namespace tandem::kart
