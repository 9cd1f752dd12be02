// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "own_elements.hpp"
#include "tandem/error.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::mbs {
namespace {

using Vector = Eigen::Map<const Eigen::Vector3d>;

/// A torque T that a body drives rotors with, through an open differential if there are several: each has T /
/// n, and the body the reaction. With a the body's vector, e a rotor's axis and W its absolute spin, its
/// speed against the body about e is
///   w = W - b . (a' - (a . e) e'),  b = (e x a) / (1 - (a . e)^2)   (a of length 1),
/// and the forces are T / n times its derivatives by the rates: on s 1, on a -b, on e (a . e) b.
class Shaft final : public ForceElement {
 public:
  /// coordinates: of a, then of e and s of each rotor.
  Shaft(std::vector<Coordinate> coordinates, int torque)
      : ForceElement(std::move(coordinates), {torque}), rotors_((this->coordinates().size() - 3) / 4) {}

  void add(const ElementState& at, double* force) const override {
    const double part = *at.u / static_cast<double>(rotors_);
    Eigen::Map<Eigen::Vector3d> body(force);
    const Vector a(at.x);
    for (std::size_t k = 0; k < rotors_; ++k) {
      const Vector e(at.x + 3 + 4 * k);
      const Eigen::Vector3d b = across(a, e);
      body -= part * b;
      Eigen::Map<Eigen::Vector3d> axis(force + 3 + 4 * k);
      axis += part * a.dot(e) * b;
      force[6 + 4 * k] += part;
    }
  }
  /// Small: torque by angle.
  void add_derivatives(const ElementState&, Eigen::Ref<Eigen::MatrixXd>,
                       Eigen::Ref<Eigen::MatrixXd>) const override {}
  bool symmetric() const override { return true; }

  std::vector<Quantity> quantities() const override {
    return {{"speed", "rad/s"}, {"torque", "N m", true}, {"power", "W", true}};
  }
  void measure(const ElementState& at, double* values) const override {
    values[0] = 0.0;
    const Vector a(at.x), a_rate(at.v);
    for (std::size_t k = 0; k < rotors_; ++k) {
      const Vector e(at.x + 3 + 4 * k), e_rate(at.v + 3 + 4 * k);
      values[0] += at.v[6 + 4 * k] - across(a, e).dot(a_rate - a.dot(e) * e_rate);
    }
    values[0] /= static_cast<double>(rotors_);
    values[1] = *at.u;
    values[2] = values[0] * values[1];
  }

 private:
  static Eigen::Vector3d across(const Vector& a, const Vector& e) {
    const double along = a.dot(e);
    return e.cross(a) / (1.0 - along * along);
  }
  std::size_t rotors_;
};

}  // namespace

void keys_of_shaft(text::KeyList& to) {
  using enum text::Key::Type;
  to.need("body", text, "A vector of the body, along which the shaft turns where rotors do not.")
      .need("axes", texts, "The axes of the rotors.")
      .need("spins", texts, "Their spins.", {.allowed = "one for each axis"})
      .need("torque", text, "The input that is its torque.", {.unit = "N m"});
}

std::unique_ptr<ForceElement> make_shaft(ElementKeys& keys) {
  auto coordinates = keys.axes(keys.vector("body"));
  const auto axes = keys.vectors("axes");
  const auto spins = keys.coordinates("spins");
  if (axes.size() != spins.size())
    keys.at("spins", [] {
      throw Error(ErrorCode::invalid_argument, "there are as many spins as axes; allowed is one for each");
    });
  for (std::size_t k = 0; k < axes.size(); ++k) {
    for (const Coordinate& c : keys.axes(axes[k])) coordinates.push_back(c);
    coordinates.push_back(spins[k]);
  }
  keys.text("torque");  // has to be there
  return std::make_unique<Shaft>(std::move(coordinates), keys.input("torque", "N m"));
}

}  // namespace tandem::mbs
