// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/relation.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "tandem/coordinator/components.hpp"

namespace tandem {
namespace {

/// By member the number of what it reads and is read by, directly or through others.
std::vector<int> loops(std::span<const Read> reads, std::span<const Member> members, bool sampled_only) {
  std::vector<std::pair<int, int>> edges;
  for (const Read& r : reads) {
    const bool both = members[static_cast<std::size_t>(r.reader)].sampled &&
                      members[static_cast<std::size_t>(r.source)].sampled;
    if (!sampled_only || (both && r.lag == 0.0 && !r.just_before)) edges.emplace_back(r.source, r.reader);
  }
  return strongly_connected(static_cast<int>(members.size()), edges);
}

/// Of two that go in turns one relation says all. They are sorted.
void unite_turns(std::vector<Relation>& all) {
  const auto same = [](const Relation& a, const Relation& b) {
    return a.kind == Relation::Kind::turns && b.kind == a.kind && a.first == b.first && a.second == b.second;
  };
  for (std::size_t k = all.size(); k-- > 1;)
    if (same(all[k - 1], all[k])) all[k - 1].lands |= all[k].lands, all[k - 1].reads |= all[k].reads;
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
}

}  // namespace

std::vector<Relation> relations(std::span<const int> order, std::span<const Read> reads,
                                std::span<const Member> members, bool turns) {
  const auto loop = loops(reads, members, false), cluster = loops(reads, members, true);
  const auto same = [](const std::vector<int>& of, const Read& r) {
    return of[static_cast<std::size_t>(r.reader)] == of[static_cast<std::size_t>(r.source)];
  };
  std::vector<std::size_t> place(members.size());
  for (std::size_t p = 0; p < order.size(); ++p) place[static_cast<std::size_t>(order[p])] = p;
  std::vector<Relation> all;
  for (const Read& r : reads) {
    const auto reader = static_cast<std::size_t>(r.reader), source = static_cast<std::size_t>(r.source);
    if (r.reader == r.source) continue;
    if (members[reader].sampled && members[source].sampled)
      all.push_back({r.reader, r.source,
                     r.just_before || same(cluster, r) ? Relation::Kind::together : Relation::Kind::after,
                     r.lag, false});
    else if (members[reader].sampled)
      all.push_back({r.reader, r.source, same(loop, r) ? Relation::Kind::nearest : Relation::Kind::passed,
                     r.lag, r.lands && same(loop, r), r.period});
    else if (members[source].sampled)
      all.push_back({r.reader, r.source, Relation::Kind::held, r.lag, r.lands});
    else if (turns && place[reader] < place[source])
      all.push_back({r.reader, r.source, Relation::Kind::turns, 0.0, false, 0.0, true});
    else if (turns)
      all.push_back({r.source, r.reader, Relation::Kind::turns, 0.0, r.lands});
  }
  const auto key = [&](const Relation& r) {
    return std::tuple(r.kind, place[static_cast<std::size_t>(r.first)],
                      place[static_cast<std::size_t>(r.second)], r.lag, r.lands, r.reads);
  };
  std::sort(all.begin(), all.end(), [&](const Relation& a, const Relation& b) { return key(a) < key(b); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  unite_turns(all);
  return all;
}

}  // namespace tandem
