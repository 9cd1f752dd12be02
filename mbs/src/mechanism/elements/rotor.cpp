// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "own_elements.hpp"
#include "tandem/error.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::mbs {
namespace {

using Vector = Eigen::Map<const Eigen::Vector3d>;

/// A body of revolution that turns about an axis e (a vector of length 1, kept so by others) with the
/// absolute spin W = s', s a free coordinate. Its kinetic energy is m |C'|^2/2 + I_d |e'|^2/2 + I_s W^2/2, so
/// that the mass is constant; what the spin does to the axis is Q_e = I_s W (e x e'), which does no work.
/// From Lagrange's equations with the quasi-coordinate s, whose variation is e . (virtual rotation). Its
/// derivatives are small beside the mass for steps below 2 I_d / (I_s W), and left out.
class Rotor final : public ForceElement {
 public:
  Rotor(std::vector<Coordinate> coordinates, double spin_inertia)
      : ForceElement(std::move(coordinates), {}), spin_inertia_(spin_inertia) {}

  void add(const ElementState& at, double* force) const override {
    Eigen::Map<Eigen::Vector3d> to(force);
    to += spin_inertia_ * at.v[3] * Vector(at.x).cross(Vector(at.v));
  }
  void add_derivatives(const ElementState&, Eigen::Ref<Eigen::MatrixXd>,
                       Eigen::Ref<Eigen::MatrixXd>) const override {}
  bool symmetric() const override { return true; }

 private:
  double spin_inertia_;
};

}  // namespace

void keys_of_rotor(text::KeyList& to) {
  using enum text::Key::Type;
  to.need("axis", text, "The vector that it turns about, of length 1.")
      .need("spin", text, "The free coordinate whose rate is its absolute spin.")
      .need("centre", text, "The point at its centre.")
      .need("mass", positive, "Its mass.", {.unit = "kg"})
      .need("spin_inertia", positive, "About the axis.", {.unit = "kg m^2"})
      .need("diametral_inertia", positive, "Across the axis.", {.unit = "kg m^2"});
}

std::unique_ptr<ForceElement> make_rotor(ElementKeys& keys) {
  if (keys.dimension() != 3)
    keys.at("kind", [] {
      throw Error(ErrorCode::invalid_argument,
                  "a rotor needs dimension = 3; in the plane a body turns as it is");
    });
  const int axis = keys.vector("axis");
  auto coordinates = keys.axes(axis);
  for (const Coordinate& c : coordinates) keys.add_inertia(c, keys.positive("diametral_inertia"));
  coordinates.push_back(keys.coordinate("spin"));
  const double inertia = keys.positive("spin_inertia");
  keys.add_inertia(coordinates.back(), inertia);
  keys.add_mass(keys.point("centre"), keys.positive("mass"));
  return std::make_unique<Rotor>(std::move(coordinates), inertia);
}

}  // namespace tandem::mbs
