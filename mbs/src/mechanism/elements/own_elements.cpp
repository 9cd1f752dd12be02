// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "own_elements.hpp"

namespace tandem::mbs {

ElementKinds own_elements() {
  return {{"drag", {"Of a point in the air: -c |v| v.", keys_of_drag, make_drag}},
          {"rotor", {"A body of revolution that turns about an axis.", keys_of_rotor, make_rotor}},
          {"shaft",
           {"A body drives rotors through an open differential, and has the reaction.", keys_of_shaft,
            make_shaft}}};
}

std::vector<Coordinate> ElementKeys::axes(int entity) const {
  std::vector<Coordinate> all;
  for (int axis = 0; axis < dimension(); ++axis) all.push_back({entity, axis});
  return all;
}

/// Steps of a millionth of a length: errors by curvature of 1e-12 and by rounding of 1e-10 of a force.
void ForceElement::add_derivatives(const ElementState& at, Eigen::Ref<Eigen::MatrixXd> k,
                                   Eigen::Ref<Eigen::MatrixXd> c) const {
  const auto n = static_cast<Eigen::Index>(coordinates().size());
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(at.x, n),
                  v = Eigen::Map<const Eigen::VectorXd>(at.v, n);
  const auto difference = [&](double& moved, double size) {
    const double middle = moved, by = 1e-6 * size;
    Eigen::VectorXd plus = Eigen::VectorXd::Zero(n), minus = plus;
    moved = middle + by;
    add({x.data(), v.data(), at.u}, plus.data());
    moved = middle - by;
    add({x.data(), v.data(), at.u}, minus.data());
    moved = middle;
    return Eigen::VectorXd((minus - plus) / (2.0 * by));
  };
  for (Eigen::Index column = 0; column < n; ++column) {
    const double size = at.size ? at.size[column] : 1.0;
    k.col(column) += difference(x[column], size);
    c.col(column) += difference(v[column], size);
  }
}

}  // namespace tandem::mbs
