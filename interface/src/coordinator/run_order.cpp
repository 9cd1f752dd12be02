// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who leads whom.
#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "feedthrough.hpp"
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

/// Whether another reads one of its outputs, or this one.
bool RunStart::is_read(int who, std::optional<int> output) const {
  const auto from = topology_.lines_from(who);
  return std::any_of(from.begin(), from.end(), [&](int k) {
    const Line& line = topology_.lines()[static_cast<std::size_t>(k)];
    return line.reader != who && line.output == output.value_or(line.output);
  });
}

/// Of equal own steps who jumps leads, as its readers then end steps where it does; who feeds an input
/// through to a reader at once follows, as it then interpolates that input. Who is read by nobody comes last: nobody
/// interpolates what it gives.
RunStart::Tie RunStart::tie(int who) const {
  if (topology_.info(who).abilities.events) return Tie::jumps;
  if (!is_read(who)) return Tie::unread;
  Tie found = Tie::plain;
  for (const Feedthrough& f : topology_.info(who).feedthrough) {
    if (!is_read(who, f.output)) continue;
    for (const int k : topology_.lines_to(who, f.input)) {
      const Line& line = topology_.lines()[static_cast<std::size_t>(k)];
      if (!topology_.at_once(line)) continue;
      if (line.how.kind == Reconstruction::Kind::held) return Tie::jumps;
      found = Tie::feeds_through;
    }
  }
  return found;
}

/// By name, so that who reads another of them at once, and feeds it through, comes behind that one. Of a circle,
/// in which no signal is, the first by name.
std::vector<int> RunStart::sources_first(std::span<const int> group) const {
  std::map<int, int> waits_for;  // so many lines of the group
  for (const int who : group) waits_for[who] = 0;
  const auto follows_at_once = [&](const Line& line) {
    return line.source != line.reader && waits_for.count(line.reader) != 0 && topology_.at_once(line) &&
           feeds(topology_.info(line.reader), line.input);
  };
  const auto each_reader = [&](int who, const auto& visit) {
    for (const int k : topology_.lines_from(who))
      if (const Line& line = topology_.lines()[static_cast<std::size_t>(k)]; follows_at_once(line))
        visit(line.reader);
  };
  for (const int who : group) each_reader(who, [&](int reader) { ++waits_for[reader]; });
  const auto by_name = [this](int a, int b) { return topology_.name(a) < topology_.name(b); };
  std::set<int, decltype(by_name)> ready(by_name), left(group.begin(), group.end(), by_name);
  for (const int who : group)
    if (waits_for[who] == 0) ready.insert(who);
  std::vector<int> order;
  while (!left.empty()) {
    const int who = ready.empty() ? *left.begin() : *ready.begin();
    ready.erase(who), left.erase(who);
    order.push_back(who);
    each_reader(who, [&](int reader) {
      if (--waits_for[reader] == 0 && left.count(reader) != 0) ready.insert(reader);
    });
  }
  return order;
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
  for (auto& group : groups) {
    std::sort(group.begin(), group.end(), [&](int a, int b) { return key(a) < key(b); });
    for (const Tie tie : {Tie::feeds_through, Tie::unread}) {
      const auto is = [&](int i) { return ties[static_cast<std::size_t>(i)] == tie; };
      const auto first = std::find_if(group.begin(), group.end(), is),
                 last = std::find_if_not(first, group.end(), is);
      const auto sorted = sources_first({first, last});
      std::copy(sorted.begin(), sorted.end(), first);
    }
  }
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
  const bool by_name = tie(group.front()) == tie(group.back()) && tie(group.front()) != Tie::feeds_through;
  run_.notes_.push_back("subsystems " + names + " have the same own step and lead in this order, " +
                        (by_name ? "by name"
                                 : "as who switches leads, who feeds inputs through at once follows what it "
                                   "reads, who is read by nobody comes last, and names decide the rest") +
                        "; coordination.order chooses another");
}

}  // namespace tandem
