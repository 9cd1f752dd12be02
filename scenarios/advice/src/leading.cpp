// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/advice/leading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace tandem::advice {
namespace {

/// What is sure of a run that is about to begin.
class Leading {
 public:
  explicit Leading(const Coordinator& run) : run_(run), topology_(run.topology()) {
    for (const int who : run.schedule().order())
      if (!sampled(who)) order_.push_back(who);
  }

  std::vector<std::string> all() const {
    std::vector<std::string> lines;
    if (run_.schedule().kind() == Schedule::Kind::parallel) return lines;
    for (const int leader : order_)
      for (const int source : order_)
        if (auto ring = ring_of(leader, source)) lines.push_back(std::move(*ring));
    if (const auto [order, moved] = better_order(); !order.empty())
      lines.push_back(moved +
                      " with events should lead who reads them, which then ends its steps there: "
                      "coordination.order = [\"" +
                      fmt::format("{}", fmt::join(order, "\", \"")) + "\"]");
    return lines;
  }

  /// The order in which those with events lead the ones without that read them, if it is another; and who moved.
  struct Better {
    std::vector<std::string> order;
    std::string moved;
  };
  Better better_order() const {
    Better better;
    if (run_.schedule().kind() == Schedule::Kind::parallel) return better;
    std::vector<int> order = order_;
    for (const int who : order_) {
      const auto reader = std::find_if(order.begin(), order.end(), [&](int other) {
        return !has_events(other) && leads(order, other, who) && reads(other, who);
      });
      if (!has_events(who) || reader == order.end()) continue;
      better.moved += (better.moved.empty() ? "" : ", ") + name(who);
      const auto at = std::find(order.begin(), order.end(), who);
      std::rotate(reader, at, at + 1);
    }
    if (better.moved.empty()) return better;
    if (run_.schedule().kind() == Schedule::Kind::fastest_first) std::reverse(order.begin(), order.end());
    for (const int who : order) better.order.push_back(topology_.name(who));
    return better;
  }

 private:
  bool sampled(int who) const { return topology_.info(who).abilities.sampled; }
  bool has_events(int who) const { return topology_.info(who).abilities.events; }
  const Line& line(int number) const { return topology_.lines()[static_cast<std::size_t>(number)]; }
  std::string name(int who) const { return "'" + topology_.name(who) + "'"; }
  bool leads(const std::vector<int>& order, int a, int b) const {
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
  }

  /// An input that the leader extrapolates, from `source`, and that is at once in an output from which it
  /// comes round.
  std::optional<std::string> ring_of(int leader, int source) const {
    if (!leads(order_, leader, source)) return std::nullopt;
    for (const Feedthrough& f : topology_.info(leader).feedthrough)
      for (const int number : topology_.lines_to(leader, f.input)) {
        const Line& in = line(number);
        if (in.source != source || !topology_.at_once(in) || in.how.kind == Reconstruction::Kind::held)
          continue;
        if (const auto way = way_round(leader, f.output, source); !way.empty())
          return "output " + topology_.output_name(leader, f.output) + " depends at once on input " +
                 topology_.input_name(leader, f.input) + ", which " + name(leader) +
                 " extrapolates, as it leads in schedule " +
                 std::string(Schedule::name(run_.schedule().kind())) +
                 "; what that errs by is in the output at once, and comes round over " + way;
      }
    return std::nullopt;
  }

  /// From an output of `from` to `to` by as few others as there are, and not over `from`; empty: there is
  /// none.
  std::string way_round(int from, int output, int to) const {
    std::vector<std::pair<int, std::size_t>> seen;  // and by whom it is reached
    const auto add = [&](int who, std::size_t by) {
      const bool known =
          std::any_of(seen.begin(), seen.end(), [who](const auto& place) { return place.first == who; });
      if (who != from && !known) seen.emplace_back(who, by);
    };
    for (const int number : topology_.lines_from(from))
      if (line(number).output == output) add(line(number).reader, 0);
    const std::size_t first = seen.size();
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (seen[k].first == to) return names_to(seen, first, k);
      for (const int number : topology_.lines_from(seen[k].first)) add(line(number).reader, k);
    }
    return {};
  }

  std::string names_to(const std::vector<std::pair<int, std::size_t>>& seen, std::size_t first,
                       std::size_t k) const {
    std::string names = name(seen[k].first);
    while (k >= first) {
      k = seen[k].second;
      names = name(seen[k].first) + ", " + names;
    }
    return names;
  }

  bool reads(int reader, int source) const {
    const auto lines = topology_.lines_from(source);
    return std::any_of(lines.begin(), lines.end(), [&](int k) { return line(k).reader == reader; });
  }

  const Coordinator& run_;
  const Topology& topology_;
  std::vector<int> order_;  ///< leaders first
};

}  // namespace

std::vector<std::string> on_leading(const Coordinator& run) { return Leading(run).all(); }

std::vector<std::string> better_order(const Coordinator& run) { return Leading(run).better_order().order; }

std::vector<std::vector<std::string>> orders(const Coordinator& run) {
  const Schedule::Kind schedule = run.schedule().kind();
  std::vector<std::string> leaders_first;
  for (const int who : run.schedule().order())
    if (!run.topology().info(who).abilities.sampled) leaders_first.push_back(run.topology().name(who));
  if (leaders_first.size() < 3 || schedule == Schedule::Kind::parallel) return {};
  std::vector<std::vector<std::string>> all = {leaders_first};
  for (auto leads = leaders_first.begin() + 1; leads != leaders_first.end(); ++leads) {
    auto& order = all.emplace_back(leaders_first);
    const auto at = order.begin() + (leads - leaders_first.begin());
    std::rotate(order.begin(), at, at + 1);
  }
  if (schedule == Schedule::Kind::fastest_first)
    for (auto& order : all) std::ranges::reverse(order);
  return all;
}

}  // namespace tandem::advice
