// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/power_link.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tandem/coordinator/units.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/subsystem_info.hpp"

namespace tandem {
namespace {

using LinkKind = PowerLink::Kind;

Scalar output_of(const Topology& topology, const Line& line) {
  return scalar_at(topology.info(line.source).outputs, line.output);
}
Scalar input_of(const Topology& topology, const Line& line) {
  return scalar_at(topology.info(line.reader).inputs, line.input);
}
std::string name_of_output(const Topology& topology, int line) {
  const Line& one = topology.lines()[static_cast<std::size_t>(line)];
  return topology.output_name(one.source, one.output);
}

bool can_carry(const Topology& topology, const Line& line) {
  return !output_of(topology, line).port->held && line.gain != 0.0;
}

/// Looks for lines that carry a power.
class LinkSearch {
 public:
  explicit LinkSearch(const Topology& topology) : topology_(topology) {
    std::map<std::pair<int, int>, std::vector<int>> of_pairs;
    for (std::size_t k = 0; k < topology.lines().size(); ++k) {
      const Line& line = topology.lines()[k];
      if (line.source != line.reader && can_carry(topology, line))
        of_pairs[{line.source, line.reader}].push_back(static_cast<int>(k));
    }
    for (const auto& [pair, there] : of_pairs)
      if (const auto back = of_pairs.find({pair.second, pair.first}); back != of_pairs.end())
        for (const int a : there)
          for (const int b : back->second)
            if (const auto link = between(a, b)) all_.push_back(*link);
  }

  std::vector<PowerLink> found() const {
    std::vector<PowerLink> some;
    std::set<int> taken;  // lines
    for (const LinkKind kind : {LinkKind::flow, LinkKind::displacement}) {
      std::map<int, int> uses;
      for (const PowerLink& link : all_)
        if (link.kind == kind) ++uses[link.effort], ++uses[link.back];
      for (const PowerLink& link : all_) {
        if (link.kind != kind || uses[link.effort] > 1 || uses[link.back] > 1) continue;
        if (taken.count(link.effort) == 0 && taken.count(link.back) == 0) some.push_back(link);
      }
      for (const PowerLink& link : all_)
        if (link.kind == kind) taken.insert({link.effort, link.back});
    }
    return some;
  }

 private:
  std::optional<PowerLink> between(int a, int b) const {
    const Line &effort = topology_.lines()[static_cast<std::size_t>(a)],
               &back = topology_.lines()[static_cast<std::size_t>(b)];
    const Scalar e = output_of(topology_, effort), f = output_of(topology_, back);
    if (e.port->size == f.port->size && e.element != f.element) return std::nullopt;
    const auto product = energy_product(input_of(topology_, effort).port->unit, f.port->unit);
    if (!product) return std::nullopt;
    return PowerLink{product->is_power ? LinkKind::flow : LinkKind::displacement, a, b, product->scale};
  }

  const Topology& topology_;
  std::vector<PowerLink> all_;
};

/// The only line from this output to a subsystem.
int line_to(const Topology& topology, const std::string& output, int reader) {
  int found = -1;
  for (std::size_t k = 0; k < topology.lines().size(); ++k) {
    const Line& line = topology.lines()[k];
    if (line.reader != reader || topology.output_name(line.source, line.output) != output) continue;
    if (found >= 0)
      throw Error(ErrorCode::invalid_argument, "output '" + output +
                                                   "' of a link is read twice by subsystem '" +
                                                   topology.name(reader) + "'; allowed is once");
    found = static_cast<int>(k);
  }
  if (found < 0 || !can_carry(topology, topology.lines()[static_cast<std::size_t>(found)]))
    throw Error(ErrorCode::invalid_argument, "output '" + output + "' of a link is " +
                                                 (found < 0 ? "not read" : "held, or read with gain 0,") +
                                                 " by subsystem '" + topology.name(reader) +
                                                 "', whose output is the link's other end");
  return found;
}

int subsystem_of(const Topology& topology, const std::string& output) {
  for (int i = 0; i < topology.size(); ++i) {
    const auto names = topology.output_names(i);
    if (std::find(names.begin(), names.end(), output) != names.end()) return i;
  }
  throw Error(ErrorCode::invalid_argument, unknown("output", output, topology.output_names()));
}

}  // namespace

std::vector<PowerLink> power_links(const Topology& topology) { return LinkSearch(topology).found(); }

PowerLink power_link(const Topology& topology, const StatedLink& link) {
  const int a = subsystem_of(topology, link.effort), b = subsystem_of(topology, link.back);
  const int effort = line_to(topology, link.effort, b), back = line_to(topology, link.back, a);
  const auto line = [&](int k) { return topology.lines()[static_cast<std::size_t>(k)]; };
  const std::string e = input_of(topology, line(effort)).port->unit,
                    f = output_of(topology, line(back)).port->unit;
  if (link.kind == LinkKind::stiffness)
    return {link.kind, effort, back, link.stiffness * displacement_scale(e) * displacement_scale(f)};
  const auto product = energy_product(e, f);
  if (e.empty() && f.empty()) return {link.kind, effort, back, 1.0};
  if (!product || product->is_power != (link.kind == LinkKind::flow))
    throw Error(ErrorCode::invalid_argument, "the units of the link from '" + link.effort + "' [" + e +
                                                 "] to '" + link.back + "' [" + f + "] make no " +
                                                 (link.kind == LinkKind::flow ? "power" : "energy"));
  return {link.kind, effort, back, product->scale};
}

std::string name_of(const Topology& topology, const PowerLink& link) {
  return name_of_output(topology, link.effort) + ":" + name_of_output(topology, link.back);
}

}  // namespace tandem
