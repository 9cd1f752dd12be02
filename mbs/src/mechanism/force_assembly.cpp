// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// How the forces of a Mechanism are made of its description.
#include <utility>

#include "central_set.hpp"
#include "constraint_set.hpp"
#include "coordinate_forces.hpp"
#include "element_set.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {
namespace {

template <class Set>
void add_if_used(std::unique_ptr<Set> set, std::vector<std::unique_ptr<ForceSet>>& sets) {
  if (!set->empty()) sets.push_back(std::move(set));
}

template <int Dimension>
std::unique_ptr<CentralSet<Dimension>> central_set(const Description& in, const Numbering& at,
                                                   const std::vector<InputValue>& inputs) {
  auto set = std::make_unique<CentralSet<Dimension>>(inputs);
  for (const Spring& s : in.springs)
    if (s.relative < 0) set->add({at.entity[s.points.from], at.entity[s.points.to], SpringLaw(s), -1, 0.0});
  for (const Force& f : in.forces)
    if (f.kind == Force::Kind::line)
      set->add({at.entity[f.points.from], at.entity[f.points.to], SpringLaw(Spring{}), f.input, f.gain});
  return set;
}

}  // namespace

std::vector<double> sizes_of(const Description& in, const ForceElement& element, double unit) {
  const auto is_length = [&](const Coordinate& c) {
    if (c.entity >= 0) return is_point(in, c.entity);
    return !is_angle(in, c) &&
           in.relatives[static_cast<std::size_t>(c.relative)].kind != Relative::Kind::state;
  };
  std::vector<double> sizes;
  for (const Coordinate& c : element.coordinates()) sizes.push_back(is_length(c) ? unit : 1.0);
  return sizes;
}

void Mechanism::add_forces() {
  const Description& in = description_;
  in.dimension == 2 ? add_if_used(central_set<2>(in, numbering_, inputs_), force_sets_)
                    : add_if_used(central_set<3>(in, numbering_, inputs_), force_sets_);
  auto springs = std::make_unique<RelativeSpringSet>();
  for (const Spring& s : in.springs)
    if (s.relative >= 0) springs->add(numbering_.relative[s.relative], SpringLaw(s));
  add_if_used(std::move(springs), force_sets_);
  auto loads = std::make_unique<LoadSet>(inputs_);
  for (const Force& f : in.forces) {
    if (f.kind == Force::Kind::relative) loads->add(numbering_.relative[f.index], f.input, f.gain);
    for (int k = 0; k < in.dimension && f.kind == Force::Kind::point; ++k)
      loads->add(numbering_.entity[f.index] + k, f.input, f.gain * f.direction[k]);
  }
  add_if_used(std::move(loads), force_sets_);
}

void Mechanism::add_elements() {
  auto elements = std::make_unique<ElementSet>(inputs_);
  for (const NamedElement& element : description_.elements) {
    elements->add(*element.force, numbering_, sizes_of(description_, *element.force, structure_.unit()));
    if (!element.force->symmetric()) structure_.symmetric_forces = false;
  }
  add_if_used(std::move(elements), force_sets_);
}

/// Entries of fixed coordinates are written behind the pattern's, where nobody reads.
void Mechanism::place_forces() {
  const int n = structure_.variables;
  const auto is_variable = [n](const auto& entry) { return entry.first < n && entry.second < n; };
  std::vector<std::pair<int, int>> entries;
  for (const auto& set : force_sets_)
    for (const auto& entry : set->entries())
      if (is_variable(entry)) entries.push_back(entry);
  structure_.stiffness = Pattern(n, n, std::move(entries));
  structure_.stiffness_extra = 1;
  for (const auto& set : force_sets_) {
    std::vector<int> to;
    for (const auto& entry : set->entries())
      to.push_back(is_variable(entry) ? structure_.stiffness.find(entry.first, entry.second)
                                      : structure_.stiffness.size());
    set->place(std::move(to));
  }
}

}  // namespace tandem::mbs
