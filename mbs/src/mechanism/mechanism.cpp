// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "distance_set.hpp"
#include "product_set.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"
#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {
namespace {

constexpr const char* axis[] = {"x", "y", "z"};

}  // namespace

Mechanism::Mechanism(const Description& description) {
  number_coordinates(description);
  add_masses(description);
  add_constraints(description);
}

Mechanism::~Mechanism() = default;

/// Variable points and vectors in the order of the description, then the fixed ones.
void Mechanism::number_coordinates(const Description& in) {
  const int d = in.dimension, entities = static_cast<int>(in.entities.size());
  first_.resize(in.entities.size());
  for (const bool fixed : {false, true})
    for (int i = 0; i < entities; ++i) {
      const Entity& e = in.entities[i];
      if (e.fixed != fixed) continue;
      first_[i] = std::exchange(structure_.coordinates, structure_.coordinates + d);
      if (fixed) continue;
      structure_.variables += d;
      for (int k = 0; k < d; ++k) structure_.variable_names.push_back(e.name + "." + axis[k]);
    }
  structure_.coordinates += d;  // zeros, where the edges that are vectors begin
  start_.q.setZero(structure_.coordinates);
  start_.v.setZero(structure_.coordinates);
  start_.a.setZero(structure_.coordinates);
  for (int i = 0; i < entities; ++i) {
    start_.q.segment(first_[i], d) = in.entities[i].at.head(d);
    if (!in.entities[i].fixed) start_.v.segment(first_[i], d) = in.entities[i].velocity.head(d);
  }
}

void Mechanism::add_masses(const Description& in) {
  const int d = in.dimension, n = structure_.variables;
  std::vector<std::pair<int, int>> entries;
  std::vector<double> values;
  weight_.setZero(n);
  for (const Body& body : in.bodies) {
    const BodyMass share = body_mass(in, body);
    const int size = static_cast<int>(share.entities.size()) * d;
    const auto variable = [&](int k) { return first_[share.entities[k / d]] + k % d; };
    const Eigen::VectorXd weight = share.weight * in.gravity.head(d);
    for (int r = 0; r < size; ++r) {
      if (variable(r) >= n) continue;
      weight_[variable(r)] += weight[r];
      for (int c = 0; c < size; ++c)
        if (variable(c) < n && share.mass(r, c) != 0.0)
          entries.emplace_back(variable(r), variable(c)), values.push_back(share.mass(r, c));
    }
  }
  structure_.mass.pattern = Pattern(n, n, entries);
  structure_.mass.values.assign(static_cast<std::size_t>(structure_.mass.pattern.size()), 0.0);
  for (std::size_t k = 0; k < entries.size(); ++k)
    structure_.mass.values[structure_.mass.pattern.find(entries[k].first, entries[k].second)] += values[k];
  structure_.stiffness = Pattern(n, n, {});
}

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

/// The set of distances and the set of other products, in this order, with the names of their equations.
template <int Dimension>
std::vector<std::unique_ptr<ConstraintSet>> sets_of(const std::vector<ScalarProduct>& products,
                                                    const std::vector<int>& first, int zero,
                                                    std::vector<std::string>& names) {
  auto distances = std::make_unique<DistanceSet<Dimension>>();
  auto others = std::make_unique<ProductSet<Dimension>>();
  const auto is_distance = [](const ScalarProduct& p) { return p.a == p.b && p.a.from >= 0; };
  const auto from = [&](const Edge& e) { return e.from < 0 ? zero : first[e.from]; };
  for (const ScalarProduct& p : products)
    if (is_distance(p)) distances->add(first[p.a.from], first[p.a.to], p.value), names.push_back(p.name);
  for (const ScalarProduct& p : products)
    if (!is_distance(p))
      others->add({first[p.a.to], from(p.a), first[p.b.to], from(p.b), p.value}), names.push_back(p.name);
  std::vector<std::unique_ptr<ConstraintSet>> sets;
  sets.push_back(std::move(distances));
  sets.push_back(std::move(others));
  return sets;
}

void Mechanism::add_constraints(const Description& in) {
  const auto products = all_products(in);
  const int zero = structure_.coordinates - in.dimension;
  sets_ = in.dimension == 2 ? sets_of<2>(products, first_, zero, structure_.constraint_names)
                            : sets_of<3>(products, first_, zero, structure_.constraint_names);
  const int n = structure_.variables;
  std::vector<std::pair<int, int>> entries;
  for (const auto& set : sets_)
    for (int e = 0; e < set->size(); ++e, ++structure_.constraints)
      for (const int c : set->coordinates(e))
        if (c < n) entries.emplace_back(c, structure_.constraints);
  structure_.jacobian = Pattern(n, structure_.constraints, std::move(entries));
  int first = 0;
  for (const auto& set : sets_) {
    std::vector<int> to;
    for (int e = 0; e < set->size(); ++e)
      for (const int c : set->coordinates(e))
        to.push_back(c < n ? structure_.jacobian.find(c, first + e) : structure_.jacobian.size());
    set->place(std::exchange(first, first + set->size()), std::move(to));
  }
}

State Mechanism::described_state() const { return start_; }

void Mechanism::constraints(const double* q, double* phi, double* jacobian) const {
  for (const auto& set : sets_) set->values(q, phi, jacobian);
}

void Mechanism::constraint_rates(const double*, double* phi_t) const {
  std::fill_n(phi_t, structure_.constraints, 0.0);
}

void Mechanism::constraint_accelerations(const double* q, const double* v, double* gamma) const {
  for (const auto& set : sets_) set->accelerations(q, v, gamma);
}

void Mechanism::forces(const double*, const double*, double* force) const {
  std::copy_n(weight_.data(), structure_.variables, force);
}

double Mechanism::energy(const double* q, const double* v) const {
  const int n = structure_.variables;
  Eigen::VectorXd momentum(n);
  multiply_symmetric(structure_.mass, v, momentum.data());
  return 0.5 * momentum.dot(Eigen::Map<const Eigen::VectorXd>(v, n)) -
         weight_.dot(Eigen::Map<const Eigen::VectorXd>(q, n));
}

}  // namespace tandem::mbs
