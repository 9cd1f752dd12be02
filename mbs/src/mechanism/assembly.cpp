// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// How a Mechanism is made of its description.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "angles.hpp"
#include "check.hpp"
#include "constraint_set.hpp"
#include "distance_set.hpp"
#include "equations.hpp"
#include "force_set.hpp"
#include "label.hpp"
#include "refuse.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {
namespace {

/// A matrix from entries that add up where they coincide.
class Sum {
 public:
  void add(int row, int column, double value) {
    entries_.emplace_back(row, column);
    values_.push_back(value);
  }
  Matrix matrix(int rows, int columns) const {
    Matrix m{Pattern(rows, columns, entries_), {}};
    m.values.assign(static_cast<std::size_t>(m.pattern.size()), 0.0);
    for (std::size_t k = 0; k < entries_.size(); ++k)
      m.values[m.pattern.find(entries_[k].first, entries_[k].second)] += values_[k];
    return m;
  }

 private:
  std::vector<std::pair<int, int>> entries_;
  std::vector<double> values_;
};

/// Those of the bodies, each once however many bodies share it, then those of the description.
std::vector<ScalarProduct> all_products(const Description& in) {
  std::vector<ScalarProduct> all;
  std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> there;
  for (const Body& body : in.bodies)
    for (ScalarProduct& p : rigid_conditions(in, body)) {
      const auto [first, last] = std::minmax({std::pair(p.a.to, p.a.from), std::pair(p.b.to, p.b.from)});
      if (there.emplace(first, last).second) all.push_back(std::move(p));
    }
  all.insert(all.end(), in.products.begin(), in.products.end());
  return all;
}

bool is_distance(const ScalarProduct& p) { return p.a == p.b && p.a.from >= 0; }

template <int Dimension>
std::unique_ptr<ConstraintSet> distance_set(const std::vector<ScalarProduct>& products, const Numbering& at,
                                            Structure& structure) {
  auto set = std::make_unique<DistanceSet<Dimension>>();
  for (const ScalarProduct& p : products) {
    if (!is_distance(p)) continue;
    set->add(at.entity[p.a.from], at.entity[p.a.to], p.value);
    label(structure, {name_of(p), "m", p.where, std::sqrt(p.value)});
  }
  return set;
}

/// All but distances and angles; the drives last.
std::vector<Quadratic> quadratics(const Description& in, const Numbering& at,
                                  const std::vector<ScalarProduct>& products, double unit) {
  std::vector<Quadratic> all;
  const auto append = [&](const std::vector<Quadratic>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (int b = 0; b < static_cast<int>(in.bodies.size()); ++b) append(dependent_entities(in, at, b));
  for (const ScalarProduct& p : products)
    if (!is_distance(p)) all.push_back(equation(in, at, p, unit));
  for (const FixedAngle& angle : in.fixed_angles)
    if (in.dimension == 2) all.push_back(equation(in, at, angle, unit));
  for (const Joint& joint : in.joints) append(equations(in, at, joint));
  for (int r = 0; r < static_cast<int>(in.relatives.size()); ++r)
    if (in.relatives[r].kind == Relative::Kind::length) all.push_back(length_equation(in, at, r));
  for (const Link& link : in.links) all.push_back(equation(in, at, link));
  for (const Relation& relation : in.relations) all.push_back(equation(in, at, relation));
  for (const Slide& slide : in.slides) append(equations(in, at, slide));
  for (const Drive& drive : in.drives) all.push_back(equation(in, at, drive));
  return all;
}

/// The largest body's, or else the longest edge of a product or length; 1 m where there is none.
double length_of(const Description& in, const std::vector<ScalarProduct>& products) {
  double length = 0.0;
  for (const Body& body : in.bodies) length = std::max(length, BodyCoordinates(in, body).size());
  for (const ScalarProduct& p : products)
    if (length == 0.0 && is_distance(p)) length = drawn(in, p.a).norm();
  for (const Relative& r : in.relatives)
    if (length == 0.0 && r.kind == Relative::Kind::length) length = drawn(in, r);
  return length > 0.0 ? length : 1.0;
}

/// A condition of fixed points and vectors alone holds or not, whatever moves.
void refuse_constant(const Structure& s) {
  for (int c = 0; c < s.constraints; ++c)
    if (s.jacobian.starts()[c] == s.jacobian.starts()[c + 1])
      refuse(
          s.constraint_places[static_cast<std::size_t>(c)],
          "constraint '" + s.constraint_names[static_cast<std::size_t>(c)] +
              "' is of points and vectors that are fixed, all of them, so it holds nothing; allowed is one "
              "with a point, vector or coordinate that moves");
}

bool points_alone(const Description& in) {
  const auto turns = [](const Entity& e) { return e.kind == Entity::Kind::vector && !e.fixed; };
  return in.relatives.empty() && std::none_of(in.entities.begin(), in.entities.end(), turns);
}

}  // namespace

Mechanism::Mechanism(Description description)
    : description_((check(description), std::move(description))), numbering_(description_) {
  structure_.coordinates = numbering_.coordinates;
  structure_.variables = numbering_.variables;
  structure_.variable_names = numbering_.variable_names;
  for (const Input& input : description_.inputs) inputs_.push_back({input.value});
  add_masses();
  add_constraints();
  place_constraints();
  add_forces();
  add_elements();
  place_forces();
  for (std::size_t r = 0; r < description_.relatives.size(); ++r)
    if (description_.relatives[r].kind == Relative::Kind::state)
      structure_.states.push_back(numbering_.relative[r]);
  if (!points_alone(description_) && structure_.length != 1.0) add_scales();
  Eigen::VectorXd q = described_state().q;
  if (!structure_.coordinate_scales.empty())
    q.array() *= Eigen::Map<const Eigen::ArrayXd>(structure_.coordinate_scales.data(), q.size());
  structure_.rounding = 8.0 * std::numeric_limits<double>::epsilon() * q.norm();
}

Mechanism::~Mechanism() = default;

void Mechanism::add_masses() {
  const Description& in = description_;
  const int d = in.dimension, n = structure_.variables;
  Sum variable, fixed;
  weight_.setZero(structure_.coordinates);
  force_.setZero(structure_.coordinates);
  const auto add = [&](int row, int column, double mass) {
    if (mass == 0.0 || column >= n) return;
    row < n ? variable.add(row, column, mass) : fixed.add(row - n, column, mass);
  };
  for (const Body& body : in.bodies) {
    const BodyMass share = body_mass(in, body);
    const int size = static_cast<int>(share.entities.size()) * d;
    const auto coordinate = [&](int k) { return numbering_.entity[share.entities[k / d]] + k % d; };
    const Eigen::VectorXd weight = share.weight * in.gravity.head(d);
    for (int r = 0; r < size; ++r) {
      weight_[coordinate(r)] += weight[r];
      for (int c = 0; c < size; ++c) add(coordinate(r), coordinate(c), share.mass(r, c));
    }
  }
  for (const PointMass& m : in.masses)
    for (int k = 0, first = numbering_.entity[m.point]; k < d; ++k) {
      weight_[first + k] += m.mass * in.gravity[k];
      add(first + k, first + k, m.mass);
    }
  for (const Inertia& i : in.inertias) add(numbering_.of(i.coordinate), numbering_.of(i.coordinate), i.value);
  structure_.mass = variable.matrix(n, n);
  fixed_mass_ = fixed.matrix(structure_.coordinates - n, n);
}

void Mechanism::add_constraints() {
  const Description& in = description_;
  const bool plane = in.dimension == 2;
  const auto products = all_products(in);
  structure_.length = length_of(in, products);
  if (!points_alone(in)) structure_.length = structure_.unit();
  sets_.push_back(plane ? distance_set<2>(products, numbering_, structure_)
                        : distance_set<3>(products, numbering_, structure_));
  sets_.push_back(angle_set(in, numbering_, structure_));
  sets_.push_back(fixed_angle_set(in, numbering_, structure_));
  auto others = std::make_unique<QuadraticSet>(inputs_);
  for (const Quadratic& q : quadratics(in, numbering_, products, structure_.unit())) {
    others->add(q);
    label(structure_, {q.name, q.unit, q.where, q.size});
  }
  sets_.push_back(std::move(others));
  std::erase_if(sets_, [](const auto& set) { return set->size() == 0; });
  structure_.constraints = static_cast<int>(structure_.constraint_names.size());
  first_drive_ = structure_.constraints - static_cast<int>(in.drives.size());
}

/// Derivatives by variables stand where the pattern has them, those by fixed coordinates behind.
void Mechanism::place_constraints() {
  const int n = structure_.variables, m = structure_.constraints;
  std::vector<std::pair<int, int>> variable, fixed;
  int equation = 0;
  for (const auto& set : sets_)
    for (int e = 0; e < set->size(); ++e, ++equation)
      for (const int c : set->coordinates(e))
        c < n ? variable.emplace_back(c, equation) : fixed.emplace_back(c - n, equation);
  structure_.jacobian = Pattern(n, m, std::move(variable));
  refuse_constant(structure_);
  fixed_jacobian_ = Pattern(structure_.coordinates - n, m, std::move(fixed));
  structure_.jacobian_extra = fixed_jacobian_.size();
  int first = 0;
  for (const auto& set : sets_) {
    std::vector<int> to;
    for (int e = 0; e < set->size(); ++e)
      for (const int c : set->coordinates(e))
        to.push_back(c < n ? structure_.jacobian.find(c, first + e)
                           : structure_.jacobian.size() + fixed_jacobian_.find(c - n, first + e));
    set->place(std::exchange(first, first + set->size()), std::move(to));
  }
}

}  // namespace tandem::mbs
