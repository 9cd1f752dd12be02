// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/turn_order.hpp"

#include <algorithm>
#include <utility>

#include "tandem/coordinator/components.hpp"

namespace tandem {

TurnOrder::TurnOrder(std::span<const int> order, std::vector<Relation> relations, TimeTolerance tolerance)
    : relations_(std::move(relations)),
      tolerance_(tolerance),
      first_(order.size() + 1),
      waits_(order.size()),
      ready_((order.size() + 63) / 64),
      group_of_(order.size()),
      earliest_(order.size()),
      in_chain_(order.size()) {
  link();
  gather_events(order);
  gather(order);
  gather_clusters();
}

/// Who ends steps at events of others that lead it.
void TurnOrder::gather_events(std::span<const int> order) {
  for (const Relation& r : relations_) {
    if (r.kind != Relation::Kind::turns || !r.lands) continue;
    lands_at_.resize(order.size());
    lands_at_[static_cast<std::size_t>(r.second)].push_back(r.first);
  }
  place_.resize(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) place_[static_cast<std::size_t>(order[p])] = p;
}

/// All stand nowhere at first: in turns it is the followers' turn everywhere, and of others none waits.
void TurnOrder::link() {
  std::vector<std::vector<Neighbour>> of(waits_.size());
  for (std::size_t k = 0; k < relations_.size(); ++k) {
    const auto& [a, b, kind, lag, lands, period, reads] = relations_[k];
    const auto number = static_cast<std::int32_t>(k);
    of[static_cast<std::size_t>(a)].push_back({b, number, Relation::Waits::first, kind});
    of[static_cast<std::size_t>(b)].push_back({a, number, Relation::Waits::second, kind});
    const bool turns = kind == Relation::Kind::turns;
    waiting_side_.push_back(turns ? Relation::Waits::first : Relation::Waits::none);
    waits_[static_cast<std::size_t>(a)] += turns ? 1 : 0;
    drift_ = drift_ || !turns;
    if (!turns) rows_.assign(waits_.size(), Member::never);
  }
  for (std::size_t i = 0; i < of.size(); ++i) {
    neighbours_.insert(neighbours_.end(), of[i].begin(), of[i].end());
    first_[i + 1] = neighbours_.size();
  }
}

void TurnOrder::gather(std::span<const int> order) {
  std::vector<char> known(order.size());
  std::vector<std::size_t> place(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) place[static_cast<std::size_t>(order[p])] = p;
  for (const int root : order) {
    if (std::exchange(known[static_cast<std::size_t>(root)], 1)) continue;
    Group group{{root}, 0, false, true};
    std::size_t ends = 0;  // of relations
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      const int who = group.members[k];
      group_of_[static_cast<std::size_t>(who)] = static_cast<int>(groups_.size());
      ends += neighbours(who).size();
      for (const Neighbour& other : neighbours(who))
        if (!std::exchange(known[static_cast<std::size_t>(other.who)], 1)) group.members.push_back(other.who);
    }
    group.has_rings = ends / 2 >= group.members.size();
    std::sort(group.members.begin(), group.members.end(), [&](int a, int b) {
      return place[static_cast<std::size_t>(a)] < place[static_cast<std::size_t>(b)];
    });
    waiting_.push_back(static_cast<int>(groups_.size()));
    groups_.push_back(std::move(group));
  }
  drift_ = drift_ || groups_.size() > 1;
}

void TurnOrder::gather_clusters() {
  std::vector<std::pair<int, int>> edges;
  for (const Relation& r : relations_)
    if (r.kind == Relation::Kind::together && r.lag == 0.0) edges.emplace_back(r.second, r.first);
  if (edges.empty()) return;
  cluster_of_ = strongly_connected(static_cast<int>(waits_.size()), edges);
  clusters_.resize(waits_.size());
  for (std::size_t i = 0; i < cluster_of_.size(); ++i)
    clusters_[static_cast<std::size_t>(cluster_of_[i])].push_back(static_cast<int>(i));
}

Relation::Waits TurnOrder::waits_of(std::span<const Member> members, const Neighbour& n, int who) const {
  const Member &m = members[static_cast<std::size_t>(who)], &other = members[static_cast<std::size_t>(n.who)];
  const Relation& r = relations_[static_cast<std::size_t>(n.relation)];
  if (n.kind == Relation::Kind::turns)
    return (n.leads() ? tolerance_.before(other.time, row_of(members, who, {n.who, true, &r}))
                      : tolerance_.before(m.time, row_of(members, n.who, {who, true, &r})))
               ? Relation::Waits::second
               : Relation::Waits::first;
  return n.mine == Relation::Waits::first ? r.waits(m, other, tolerance_) : r.waits(other, m, tolerance_);
}

void TurnOrder::moved(std::span<const Member> members, int who) {
  if (!rows_.empty()) rows_[static_cast<std::size_t>(who)] = earliest_row(members, who);
  look_again(members, who);
  if (!lands_at_.empty())
    for (const Neighbour& n : neighbours(who))
      if (n.kind == Relation::Kind::turns && !n.leads() &&
          relations_[static_cast<std::size_t>(n.relation)].lands)
        look_again(members, n.who);
  if (drift_) earliest_.set(static_cast<std::size_t>(who), next_of(members, who));
}

/// Who waits, of those that it is related to.
void TurnOrder::look_again(std::span<const Member> members, int who) {
  for (const Neighbour& n : neighbours(who)) {
    const Relation::Waits now = waits_of(members, n, who);
    if (now != waiting_side_[static_cast<std::size_t>(n.relation)]) change(members, who, n, now);
  }
  mark(members, who);
}

void TurnOrder::change(std::span<const Member> members, int who, const Neighbour& n, Relation::Waits to) {
  const Relation::Waits from = std::exchange(waiting_side_[static_cast<std::size_t>(n.relation)], to);
  waits_[static_cast<std::size_t>(who)] += static_cast<int>(to == n.mine) - static_cast<int>(from == n.mine);
  const auto other = [&n](Relation::Waits w) {
    return static_cast<int>(w != n.mine && w != Relation::Waits::none);
  };
  waits_[static_cast<std::size_t>(n.who)] += other(to) - other(from);
  mark(members, n.who);
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

/// That of its next node; or before, where a sampled one may want a step to end that has not told it yet; or
/// where it stands, if an input may jump there, and outputs with it. It waits itself for these sampled ones.
double TurnOrder::earliest_row(std::span<const Member> members, int who) const {
  const Member& m = members[static_cast<std::size_t>(who)];
  double row = m.jumped ? m.time : m.next;
  if (m.finished()) return row;
  for (const Neighbour& n : neighbours(who)) {
    if (n.kind == Relation::Kind::turns) continue;
    const Relation& r = relations_[static_cast<std::size_t>(n.relation)];
    const Member& other = members[static_cast<std::size_t>(n.who)];
    if (n.mine == Relation::Waits::second && r.ends_steps())
      row = std::min(row, std::max(r.known(other), m.time));
    if (m.jumps && n.mine == Relation::Waits::first && n.kind == Relation::Kind::held &&
        !tolerance_.before(m.time, other.next + r.lag))
      row = m.time;
  }
  return row;
}

/// Where others that lead `who` stand may be an event at which that ends a step, and which its leader is to
/// know. One that stands with `leader` and comes later in the order does not keep it from its next own step.
double TurnOrder::earliest_event(std::span<const Member> members, int who, int leader, bool waits) const {
  const double time = members[static_cast<std::size_t>(leader)].time, next = next_of(members, who);
  double earliest = Member::never;
  for (const int other : lands_at_[static_cast<std::size_t>(who)]) {
    const double t = members[static_cast<std::size_t>(other)].time;
    const bool later = place_[static_cast<std::size_t>(other)] > place_[static_cast<std::size_t>(leader)];
    const bool steps = waits && later && !tolerance_.before(t, time);
    if (other != leader && !steps && tolerance_.before(t, next)) earliest = std::min(earliest, t);
  }
  return earliest;
}

/// Leaders stand past its next node, followers' next nodes lie past where it stands, outputs of sampled ones
/// are known, and where it ends steps for them.
double TurnOrder::limit(std::span<const Member> members, int who) const {
  const Member& m = members[static_cast<std::size_t>(who)];
  if (m.one_step) return m.next;
  double limit = m.landing;
  for (const Neighbour& n : neighbours(who)) {
    const Member& other = members[static_cast<std::size_t>(n.who)];
    const Relation& r = relations_[static_cast<std::size_t>(n.relation)];
    if (n.kind == Relation::Kind::turns)
      limit = std::min(limit, n.leads() ? other.time : row_of(members, n.who, {who, false, &r}));
    else if (n.kind == Relation::Kind::held)
      limit = std::min(limit, other.next + r.lag);
    else if (n.mine == Relation::Waits::second && r.ends_steps())
      limit = std::min(limit, r.known(other));
  }
  return limit;
}

double TurnOrder::landing(std::span<const Member> members, int who, TimeSpan ahead) const {
  double change = ahead.stop, read = Member::never;  // of what it reads, and where it is read
  for (const Neighbour& n : neighbours(who)) {
    if (n.kind == Relation::Kind::turns) continue;
    const Relation& r = relations_[static_cast<std::size_t>(n.relation)];
    if (!r.lands) continue;
    const bool held = r.kind == Relation::Kind::held;
    const double instant = next_of(members, n.who), t = held ? instant + r.lag : instant - r.lag;
    double& first = held ? change : read;
    if (instant != Member::never && tolerance_.before(ahead.start, t)) first = std::min(first, t);
  }
  return tolerance_.before(read, change) ? read : change;
}

}  // namespace tandem
