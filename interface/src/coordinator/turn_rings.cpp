// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Members of which each waits for the next.
#include <algorithm>
#include <utility>

#include "tandem/coordinator/turn_order.hpp"

namespace tandem {

/// One in each group of which all wait.
std::span<const int> TurnOrder::out_of_rings(std::span<const Member> members) {
  out_of_rings_.clear();
  std::erase_if(waiting_, [&](int g) {
    Group& group = groups_[static_cast<std::size_t>(g)];
    const int from = group.ready == 0 ? earliest_of(members, group) : -1;
    if (from >= 0) out_of_rings_.push_back(out_of_ring(members, from));
    return !(group.waits = from >= 0);
  });
  return out_of_rings_;
}

/// One in each group in which sampled ones that wait for nobody are to act together with others that do.
std::span<const int> TurnOrder::out_of_clusters(std::span<const Member> members) {
  out_of_rings_.clear();
  if (clusters_.empty()) return {};
  for (const Group& group : groups_)
    if (const int from = earliest_of(members, group); from >= 0)
      out_of_rings_.push_back(out_of_ring(members, from));
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

/// Of sampled ones that read each other one that is to act at the same instant, and waits; -1: none.
int TurnOrder::waiting_mate(std::span<const Member> members, int who) const {
  const auto& cluster = clusters_[static_cast<std::size_t>(cluster_of_[static_cast<std::size_t>(who)])];
  for (const int mate : cluster)
    if (waits(mate) && !tolerance_.before(next_of(members, who), next_of(members, mate))) return mate;
  return -1;
}

std::optional<TurnOrder::Neighbour> TurnOrder::first_waited_for(std::span<const Member> members,
                                                                int who) const {
  for (const Neighbour& n : neighbours(who))
    if (waits_for(n) && std::find(freed_.begin(), freed_.end(), n.relation) == freed_.end()) return n;
  if (const int mate = clusters_.empty() ? -1 : waiting_mate(members, who); mate >= 0 && mate != who)
    return Neighbour{mate, -1, Relation::Waits::none, Relation::Kind::together};
  return std::nullopt;
}

int TurnOrder::out_of_ring(std::span<const Member> members, int from) {
  freed_.clear();
  chain_.assign(1, {from, -1, Relation::Waits::none, Relation::Kind::together});
  in_chain_[static_cast<std::size_t>(from)] = 1;
  while (const auto n = first_waited_for(members, from)) {
    const bool closed = std::exchange(in_chain_[static_cast<std::size_t>(n->who)], 1) != 0;
    chain_.push_back(*n);
    from = closed ? open_ring() : n->who;
  }
  for (const Neighbour& n : chain_) in_chain_[static_cast<std::size_t>(n.who)] = 0;
  return from;
}

/// In a ring that begins there in the chain, who waits no longer for the one behind him: the first leader
/// that waits for a follower, else the first follower of a leader that waits for a sampled one.
std::size_t TurnOrder::freed_of_ring(std::size_t begin) const {
  const std::size_t end = chain_.size() - 1;
  const auto turns = [&](std::size_t k) { return chain_[k + 1].kind == Relation::Kind::turns; };
  for (std::size_t k = begin; k < end; ++k)
    if (turns(k) && !chain_[k + 1].leads()) return k;
  for (std::size_t k = begin; k < end; ++k)
    if (turns(k) && !turns(k + 1 < end ? k + 1 : begin)) return k;
  return begin;
}

/// The last of the chain is there before, too. Whoever is freed there is the chain's end.
int TurnOrder::open_ring() {
  std::size_t k = 0;
  while (chain_[k].who != chain_.back().who) ++k;
  k = freed_of_ring(k);
  freed_.push_back(chain_[k + 1].relation);
  in_chain_[static_cast<std::size_t>(chain_.back().who)] = 0;
  for (; chain_.size() > k + 1; chain_.pop_back()) in_chain_[static_cast<std::size_t>(chain_.back().who)] = 0;
  for (const Neighbour& n : chain_) in_chain_[static_cast<std::size_t>(n.who)] = 1;
  return chain_.back().who;
}

}  // namespace tandem
