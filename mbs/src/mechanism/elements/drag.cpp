// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "own_elements.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::mbs {
namespace {

/// On a point, against its velocity or one component of it: -c |v| v, c in N s^2/m^2 (in air density times
/// C_d A / 2).
class Drag final : public ForceElement {
 public:
  Drag(std::vector<Coordinate> point, double coefficient)
      : ForceElement(std::move(point), {}), coefficient_(coefficient) {}

  void add(const ElementState& at, double* force) const override {
    const auto v = velocity(at);
    Eigen::Map<Short>(force, v.size()) -= coefficient_ * v.norm() * v;
  }
  /// C = c (|v| + v v^T / |v|).
  void add_derivatives(const ElementState& at, Eigen::Ref<Eigen::MatrixXd>,
                       Eigen::Ref<Eigen::MatrixXd> c) const override {
    const auto v = velocity(at);
    const double speed = v.norm();
    c.diagonal().array() += coefficient_ * speed;
    if (speed > 0.0) c += coefficient_ / speed * v * v.transpose();
  }
  bool symmetric() const override { return true; }
  std::vector<Quantity> quantities() const override { return {{"power", "W"}}; }
  void measure(const ElementState& at, double* values) const override {
    *values = -coefficient_ * std::pow(velocity(at).norm(), 3);
  }

 private:
  using Short = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;  // so that products allocate nothing
  Eigen::Map<const Short> velocity(const ElementState& at) const {
    return {at.v, static_cast<Eigen::Index>(coordinates().size())};
  }
  double coefficient_;
};

}  // namespace

void keys_of_drag(text::KeyList& to) {
  using enum text::Key::Type;
  to.need("point", text, "The point.")
      .may("along", word, "Of that component of its velocity alone.", {.words = {"x", "y", "z"}})
      .need("coefficient", positive, "c.", {.unit = "N s^2/m^2"});
}

std::unique_ptr<ForceElement> make_drag(ElementKeys& keys) {
  auto coordinates = keys.axes(keys.point("point"));
  if (keys.has("along")) {
    const auto k = std::string("xyz").find(keys.text("along"));
    if (k >= coordinates.size()) keys.leave_out("along", "there is no z in the plane");
    coordinates = {coordinates[k]};
  }
  return std::make_unique<Drag>(std::move(coordinates), keys.positive("coefficient"));
}

}  // namespace tandem::mbs
