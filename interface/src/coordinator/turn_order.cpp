// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/turn_order.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tandem {

TurnOrder::TurnOrder(std::vector<int> order, std::span<const Read> reads, TimeTolerance tolerance)
    : order_(std::move(order)),
      place_(order_.size()),
      tolerance_(tolerance),
      first_(order_.size() + 1),
      waits_(order_.size()),
      ready_((order_.size() + 63) / 64),
      group_of_(order_.size()),
      earliest_(order_.size()),
      in_chain_(order_.size()) {
  for (std::size_t p = 0; p < order_.size(); ++p) place_[static_cast<std::size_t>(order_[p])] = p;
  link(reads);
  gather();
}

/// All stand nowhere at first, which makes it the followers' turn everywhere.
void TurnOrder::link(std::span<const Read> reads) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // places of leader and follower
  for (const Read& r : reads)
    if (r.reader != r.source)
      pairs.push_back(std::minmax(
          {place_[static_cast<std::size_t>(r.reader)], place_[static_cast<std::size_t>(r.source)]}));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::vector<Neighbour>> of(order_.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const int leader = order_[pairs[k].first], follower = order_[pairs[k].second];
    of[static_cast<std::size_t>(follower)].push_back({leader, static_cast<std::int32_t>(k), true});
    of[static_cast<std::size_t>(leader)].push_back({follower, static_cast<std::int32_t>(k), false});
    ++waits_[static_cast<std::size_t>(leader)];
  }
  for (std::size_t i = 0; i < of.size(); ++i) {
    std::sort(of[i].begin(), of[i].end(), [this](const Neighbour& a, const Neighbour& b) {
      return place_[static_cast<std::size_t>(a.who)] < place_[static_cast<std::size_t>(b.who)];
    });
    neighbours_.insert(neighbours_.end(), of[i].begin(), of[i].end());
    first_[i + 1] = neighbours_.size();
  }
  leaders_turn_.assign(pairs.size(), 0);
}

void TurnOrder::gather() {
  std::vector<char> known(order_.size());
  for (const int root : order_) {
    if (std::exchange(known[static_cast<std::size_t>(root)], 1)) continue;
    Group group{{root}, 0, false, true};
    std::size_t ends = 0;  // of pairs
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      const int who = group.members[k];
      group_of_[static_cast<std::size_t>(who)] = static_cast<int>(groups_.size());
      ends += neighbours(who).size();
      for (const Neighbour& other : neighbours(who))
        if (!std::exchange(known[static_cast<std::size_t>(other.who)], 1)) group.members.push_back(other.who);
    }
    group.has_rings = ends / 2 >= group.members.size();
    std::sort(group.members.begin(), group.members.end(), [this](int a, int b) {
      return place_[static_cast<std::size_t>(a)] < place_[static_cast<std::size_t>(b)];
    });
    waiting_.push_back(static_cast<int>(groups_.size()));
    groups_.push_back(std::move(group));
  }
}

void TurnOrder::moved(std::span<const Member> members, int who) {
  const Member& m = members[static_cast<std::size_t>(who)];
  for (const Neighbour& n : neighbours(who)) {
    const Member& other = members[static_cast<std::size_t>(n.who)];
    const bool leaders =
        n.leads ? tolerance_.before(other.time, m.next) : tolerance_.before(m.time, other.next);
    char& turn = leaders_turn_[static_cast<std::size_t>(n.pair)];
    if (leaders == (turn != 0)) continue;
    turn = leaders ? 1 : 0;
    const int change = leaders == n.leads ? 1 : -1;
    waits_[static_cast<std::size_t>(who)] += change;
    waits_[static_cast<std::size_t>(n.who)] -= change;
    mark(members, n.who);
  }
  mark(members, who);
  if (groups_.size() > 1) earliest_.set(static_cast<std::size_t>(who), m.next);
}

/// Notes whether it is ready.
void TurnOrder::mark(std::span<const Member> members, int who) {
  const auto i = static_cast<std::size_t>(who);
  const std::uint64_t bit = std::uint64_t{1} << (i % 64);
  std::uint64_t& word = ready_[i / 64];
  const bool ready = waits_[i] == 0 && !members[i].finished();
  if (ready == ((word & bit) != 0)) return;
  word ^= bit;
  Group& group = groups_[static_cast<std::size_t>(group_of_[i])];
  group.ready += ready ? 1 : -1;
  if (group.ready == 0 && group.has_rings && !std::exchange(group.waits, true))
    waiting_.push_back(group_of_[i]);
}

/// Leaders stand past its next node, and followers' next nodes lie past where it stands.
double TurnOrder::limit(std::span<const Member> members, int who) const {
  const Member& m = members[static_cast<std::size_t>(who)];
  if (m.reads_mean) return m.next;
  double limit = Member::never;
  for (const Neighbour& n : neighbours(who)) {
    const Member& other = members[static_cast<std::size_t>(n.who)];
    limit = std::min(limit, n.leads ? other.time : other.next);
  }
  return limit;
}

/// One in each group of which all wait.
std::span<const int> TurnOrder::out_of_rings(std::span<const Member> members) {
  out_of_rings_.clear();
  std::erase_if(waiting_, [&](int g) {
    Group& group = groups_[static_cast<std::size_t>(g)];
    const int from = group.ready == 0 ? earliest_of(members, group) : -1;
    if (from >= 0) out_of_rings_.push_back(out_of_ring(from));
    return !(group.waits = from >= 0);
  });
  return out_of_rings_;
}

/// That with the earliest next node; -1 if all have finished.
int TurnOrder::earliest_of(std::span<const Member> members, const Group& group) const {
  int who = -1;
  double earliest = Member::never;
  for (const int other : group.members)
    if (next_of(members, other) < earliest) earliest = next_of(members, who = other);
  return who;
}

const TurnOrder::Neighbour* TurnOrder::first_waited_for(int who) const {
  for (const Neighbour& n : neighbours(who))
    if (waits_for(n) && std::find(freed_.begin(), freed_.end(), n.pair) == freed_.end()) return &n;
  return nullptr;
}

int TurnOrder::out_of_ring(int from) {
  freed_.clear();
  chain_.assign(1, {from, -1, false});
  in_chain_[static_cast<std::size_t>(from)] = 1;
  while (const Neighbour* n = first_waited_for(from)) {
    const bool closed = std::exchange(in_chain_[static_cast<std::size_t>(n->who)], 1) != 0;
    chain_.push_back(*n);
    from = closed ? open_ring() : n->who;
  }
  for (const Neighbour& n : chain_) in_chain_[static_cast<std::size_t>(n.who)] = 0;
  return from;
}

/// The last of the chain is there before, too: from there on the first leader that waits for a follower waits
/// for it no longer, and is the chain's end.
int TurnOrder::open_ring() {
  std::size_t k = 0;
  while (chain_[k].who != chain_.back().who) ++k;
  while (chain_[k + 1].leads) ++k;
  freed_.push_back(chain_[k + 1].pair);
  in_chain_[static_cast<std::size_t>(chain_.back().who)] = 0;
  for (; chain_.size() > k + 1; chain_.pop_back()) in_chain_[static_cast<std::size_t>(chain_.back().who)] = 0;
  for (const Neighbour& n : chain_) in_chain_[static_cast<std::size_t>(n.who)] = 1;
  return chain_.back().who;
}

}  // namespace tandem
