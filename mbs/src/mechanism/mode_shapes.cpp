// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "../dense.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"
#include "tandem/mbs/mechanism/modes.hpp"

namespace tandem::mbs {
namespace {

using Eigen::Vector3d;
constexpr std::array axes = {"x", "y", "z"};

/// The velocity of a body's centre, then its turning, as its points and vectors move in a mode: of those that
/// determine less, the least.
class RigidMotion {
 public:
  RigidMotion(const Mechanism& mechanism, const Body& body, const Mode& mode) {
    const Description& in = mechanism.description();
    const auto entities = defining_entities(in, body);
    Eigen::MatrixXd to(3 * entities.size(), 6);
    Eigen::VectorXcd rates = Eigen::VectorXcd::Zero(to.rows());
    for (std::size_t k = 0; k < entities.size(); ++k) {
      const Entity& e = in.entities[static_cast<std::size_t>(entities[k])];
      const bool point = e.kind == Entity::Kind::point;
      const Vector3d arm = point ? Vector3d(e.at - body.centre) : e.at;
      const auto row = static_cast<Eigen::Index>(3 * k);
      to.block<3, 3>(row, 0) = point ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : Eigen::Matrix3d::Zero();
      to.block<3, 3>(row, 3) << 0.0, arm[2], -arm[1], -arm[2], 0.0, arm[0], arm[1], -arm[0], 0.0;
      if (!e.fixed)
        rates.segment(row, in.dimension) =
            mode.shape.segment(mechanism.coordinate(entities[k]), in.dimension);
    }
    motion_ << dense::shortest_solution(to, rates.real()), dense::shortest_solution(to, rates.imag());
  }
  /// Squares of the three velocities and three rates of turning.
  double square(int component) const {
    return motion_[component] * motion_[component] + motion_[component + 6] * motion_[component + 6];
  }

 private:
  Eigen::Matrix<double, 12, 1> motion_;
};

/// Twice the energy of a body in each of the six components.
void add(const Mechanism& mechanism, const Body& body, const Mode& mode, std::vector<Share>& to) {
  const RigidMotion motion(mechanism, body, mode);
  for (int k = 0; k < 6; ++k)
    to.push_back({body.name + (k < 3 ? " along " : " about ") + axes[static_cast<std::size_t>(k % 3)],
                  (k < 3 ? body.mass : body.inertia(k - 3, k - 3)) * motion.square(k)});
}

const Body* heaviest(const Description& in) {
  const auto found = std::max_element(in.bodies.begin(), in.bodies.end(),
                                      [](const Body& a, const Body& b) { return a.mass < b.mass; });
  return found == in.bodies.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Share> shares(const Mechanism& mechanism, const Mode& mode) {
  const Description& in = mechanism.description();
  std::vector<Share> all;
  for (const Body& body : in.bodies) add(mechanism, body, mode, all);
  for (const PointMass& mass : in.masses)
    for (int axis = 0; axis < in.dimension && !in.entities[static_cast<std::size_t>(mass.point)].fixed;
         ++axis)
      all.push_back({mass.name + " along " + axes[static_cast<std::size_t>(axis)],
                     mass.mass * std::norm(mode.shape[mechanism.coordinate(mass.point) + axis])});
  for (const Inertia& inertia : in.inertias) {
    const int i = mechanism.numbering().of(inertia.coordinate);
    const bool state =
        inertia.coordinate.relative >= 0 &&
        in.relatives[static_cast<std::size_t>(inertia.coordinate.relative)].kind == Relative::Kind::state;
    if (!state && i < mechanism.structure().variables)
      all.push_back({mechanism.structure().variable_names[static_cast<std::size_t>(i)],
                     inertia.value * std::norm(mode.shape[i])});
  }
  double sum = 0.0;
  for (const Share& share : all) sum += share.part;
  for (Share& share : all) share.part = sum > 0.0 ? share.part / sum : 0.0;
  std::stable_sort(all.begin(), all.end(), [](const Share& a, const Share& b) { return a.part > b.part; });
  return all;
}

std::string name_of(const Mechanism& mechanism, const Mode& mode) {
  const auto all = shares(mechanism, mode);
  if (all.empty() || !(all[0].part > 0.0)) return "state";
  const Body* body = heaviest(mechanism.description());
  constexpr std::array<std::pair<const char*, const char*>, 6> words = {{{" along x", "surge"},
                                                                         {" along y", "sway"},
                                                                         {" along z", "heave"},
                                                                         {" about x", "roll"},
                                                                         {" about y", "pitch"},
                                                                         {" about z", "yaw"}}};
  if (body && mechanism.description().dimension == 3)
    for (const auto& [component, word] : words)
      if (all[0].name == body->name + component) return word;
  return all[0].name;
}

}  // namespace tandem::mbs
