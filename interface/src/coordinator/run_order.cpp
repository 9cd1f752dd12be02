// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who leads whom.
#include <algorithm>
#include <utility>

#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {

void RunStart::check_named_order() const {
  const auto& named = run_.coordination_.order;
  const auto refuse_name = [](const std::string& name, const std::string& why) {
    throw Error(ErrorCode::invalid_argument,
                "coordination.order must name each subsystem once, slowest first; '" + name + "' " + why);
  };
  for (const std::string& name : named) {
    bool known = false, acts = false;
    for (int i = 0; i < topology_.size(); ++i)
      if (topology_.name(i) == name) known = true, acts = sampled(i);
    if (!known) refuse_name(name, "is not a subsystem");
    if (acts) refuse_name(name, "is sampled, and has no place there");
    if (std::count(named.begin(), named.end(), name) > 1) refuse_name(name, "stands there twice");
  }
  for (int i = 0; i < topology_.size(); ++i)
    if (!sampled(i) && std::find(named.begin(), named.end(), topology_.name(i)) == named.end())
      refuse_name(topology_.name(i), "is missing");
}

/// Of equal own steps who jumps leads, as its readers then end steps where it does; who feeds an input
/// through to a reader at once follows, as it then interpolates that input.
RunStart::Tie RunStart::tie(int who) const {
  if (topology_.info(who).abilities.events) return Tie::jumps;
  Tie found = Tie::plain;
  for (const Feedthrough& f : topology_.info(who).feedthrough) {
    const auto from = topology_.lines_from(who);
    if (std::none_of(from.begin(), from.end(), [&](int k) {
          const Line& line = topology_.lines()[static_cast<std::size_t>(k)];
          return line.output == f.output && line.reader != who;
        }))
      continue;
    for (const int k : topology_.lines_to(who, f.input)) {
      const Line& line = topology_.lines()[static_cast<std::size_t>(k)];
      if (!topology_.at_once(line)) continue;
      if (line.how.kind == Reconstruction::Kind::held) return Tie::jumps;
      found = Tie::feeds_through;
    }
  }
  return found;
}

/// Groups of those that integrate themselves, own steps rising; within a group they are equal, and who leads
/// comes first.
std::vector<std::vector<int>> RunStart::by_own_steps() const {
  std::vector<int> all;
  std::vector<Tie> ties;
  for (int i = 0; i < topology_.size(); ++i) {
    if (!sampled(i)) all.push_back(i);
    ties.push_back(tie(i));
  }
  const auto key = [&](int i) { return std::pair(ties[static_cast<std::size_t>(i)], topology_.name(i)); };
  std::sort(all.begin(), all.end(), [&](int a, int b) { return run_.own_step(a) < run_.own_step(b); });
  std::vector<std::vector<int>> groups;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == 0 || run_.tolerance_.before(run_.t_start_ + run_.own_step(all[k - 1]),
                                         run_.t_start_ + run_.own_step(all[k])))
      groups.emplace_back();
    groups.back().push_back(all[k]);
  }
  for (auto& group : groups)
    std::sort(group.begin(), group.end(), [&](int a, int b) { return key(a) < key(b); });
  return groups;
}

std::vector<int> RunStart::leaders_first() const {
  auto groups = by_own_steps();
  const auto& named = run_.coordination_.order;
  const bool ascending = run_.coordination_.schedule == Schedule::Kind::fastest_first;
  if (!ascending) std::reverse(groups.begin(), groups.end());
  std::vector<int> order;
  for (const auto& group : groups) {
    order.insert(order.end(), group.begin(), group.end());
    if (named.empty()) note_tie(group);
  }
  if (named.empty()) return order;
  check_named_order();
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::find(named.begin(), named.end(), topology_.name(a)) <
           std::find(named.begin(), named.end(), topology_.name(b));
  });
  if (ascending) std::reverse(order.begin(), order.end());
  return order;
}

std::vector<int> RunStart::sampled_by_name() const {
  std::vector<int> all;
  for (int i = 0; i < topology_.size(); ++i)
    if (sampled(i)) all.push_back(i);
  std::sort(all.begin(), all.end(), [&](int a, int b) { return topology_.name(a) < topology_.name(b); });
  return all;
}

bool RunStart::read_each_other(const std::vector<int>& group) const {
  std::vector<char> there(static_cast<std::size_t>(topology_.size()));
  for (const int who : group) there[static_cast<std::size_t>(who)] = 1;
  return std::any_of(topology_.lines().begin(), topology_.lines().end(), [&](const Line& line) {
    return line.source != line.reader && there[static_cast<std::size_t>(line.source)] &&
           there[static_cast<std::size_t>(line.reader)];
  });
}

/// Where a rule chose between those that read each other.
void RunStart::note_tie(const std::vector<int>& group) const {
  if (group.size() < 2 || run_.coordination_.schedule == Schedule::Kind::parallel || !read_each_other(group))
    return;
  std::string names;
  for (std::size_t k = 0; k < std::min<std::size_t>(group.size(), 4); ++k)
    names += (k > 0 ? ", '" : "'") + topology_.name(group[k]) + "'";
  if (group.size() > 4) names += " and " + std::to_string(group.size() - 4) + " more";
  const bool by_name = tie(group.front()) == tie(group.back());
  run_.notes_.push_back("subsystems " + names + " have the same own step and lead in this order, " +
                        (by_name ? "by name"
                                 : "as who switches leads, who feeds inputs through at once follows, and "
                                   "names decide the rest") +
                        "; coordination.order chooses another");
}

}  // namespace tandem
