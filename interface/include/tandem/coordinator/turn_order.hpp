// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tandem/coordinator/earliest.hpp"
#include "tandem/coordinator/relation.hpp"

namespace tandem {

/// Whose turn it is: a pure function of the clocks. Its header is long, as what a turn calls stands in it, and the rule is
/// told here whole.
///
/// Two that integrate themselves are linked if one reads the other; the one that is earlier in the order
/// leads. It is the follower's turn if the leader stands at or past the end of the follower's next step, so
/// that the follower interpolates; else it is the leader's. A member is ready when it waits for none of those
/// that it is related to.
///
/// Of two that are linked never both are ready, and each step reads the same samples whatever goes first
/// elsewhere. A leader's step reads samples of the follower up to where the leader stands. A follower's step
/// reads samples of the leader up to the first one at or past the end of that step. Members that have nothing
/// to do with each other do not wait for each other. A follower may give a row before its next node, at an
/// instant that is not known yet. Its leader waits for that row too; else it would read it or not by chance.
///
/// A sampled member acts at its instant t when all that it reads stand at t, can't come nearer without
/// passing it, or, where they do not depend on it, have passed it. Who reads it goes up to where its outputs
/// may change next (Relation).
///
/// Three and more can wait in a ring, where A leads B and C, and B leads C:
/// - C waits for B to pass its node;
/// - B waits for A to pass its own;
/// - A, which stands past C's node, waits for C.
///
/// When all of a group that is linked wait, go from the one with the earliest node to the first that it waits
/// for. Go on to the first that this one waits for, and so on until the ring is closed. The first leader of
/// the ring goes without the sample of the follower that it waits for there. (So do subsystems that all read
/// all.) Where none is there, a follower goes without the leader that waits
/// for a sampled one.
class TurnOrder {
 public:
  TurnOrder() = default;
  /// order: all members, leaders first. relations: see relations().
  TurnOrder(std::span<const int> order, std::vector<Relation> relations, TimeTolerance tolerance);

  /// One of the members stands elsewhere now.
  void moved(std::span<const Member> members, int who);

  /// Calls take(who, limit) for each that has a turn: it may go up to `limit`, or to its next node where that
  /// is later; a sampled one acts. Groups that are not linked stay together, and so do those with sampled
  /// members: who stands further than `ahead` [s] past the earliest next node of all waits for that.
  template <class Take>
  void each_turn(std::span<const Member> members, double ahead, const Take& take) {
    bool any = false;
    if (!waiting_.empty())
      for (const int who : out_of_rings(members)) take(who, next_of(members, who)), any = true;
    const double latest = drift_ ? earliest_.value() + ahead : Member::never;
    any = each_ready(members, latest, take) || any;
    if (!any && !each_ready(members, Member::never, take))
      for (const int who : out_of_clusters(members)) take(who, next_of(members, who));
  }

  /// Calls take(who, limit) for each that waits for none and stands at `latest` or before; false if there was
  /// none.
  template <class Take>
  bool each_ready(std::span<const Member> members, double latest, const Take& take) const {
    bool any = false;
    for (std::size_t w = 0; w < ready_.size(); ++w)
      for (std::uint64_t bits = ready_[w]; bits != 0; bits &= bits - 1) {
        const int who = static_cast<int>(w * 64) + std::countr_zero(bits);
        if (members[static_cast<std::size_t>(who)].time > latest || mate_waits(members, who)) continue;
        take(who, limit(members, who));
        any = true;
      }
    return any;
  }

  /// How far one that waits for none may go.
  double limit(std::span<const Member> members, int who) const;
  bool waits(int who) const { return waits_[static_cast<std::size_t>(who)] > 0; }
  /// Where `who`, which stands at ahead.start, is to end a step next: at ahead.stop, where an input is known
  /// to change (`never` for none), or before at an instant of a sampled member. Of times that are equal but
  /// for rounding it takes the time of the change. That time is known first, so the moment of the call does
  /// not matter.
  double landing(std::span<const Member> members, int who, TimeSpan ahead) const;
  /// Calls visit(other) for each that `who` is related to.
  template <class Visit>
  void each_neighbour(int who, const Visit& visit) const {
    for (const Neighbour& n : neighbours(who)) visit(n.who);
  }

 private:
  struct Neighbour {
    std::int32_t who, relation;
    Relation::Waits mine;  ///< as this relation says that one waits for the neighbour
    Relation::Kind kind;
    bool leads() const { return kind == Relation::Kind::turns && mine == Relation::Waits::second; }
  };
  /// Members that are linked, directly or by others.
  struct Group {
    std::vector<int> members;  ///< leaders first
    int ready = 0;
    bool has_rings = false;  ///< more relations than it takes to link them
    bool waits = false;      ///< is in waiting_
  };

  std::span<const Neighbour> neighbours(int who) const {
    const auto i = static_cast<std::size_t>(who);
    return {neighbours_.data() + first_[i], neighbours_.data() + first_[i + 1]};
  }
  bool waits_for(const Neighbour& n) const {
    return waiting_side_[static_cast<std::size_t>(n.relation)] == n.mine;
  }
  static double next_of(std::span<const Member> members, int who) {
    return members[static_cast<std::size_t>(who)].next;
  }
  struct Leader {
    int who;
    bool waits;  ///< asked is whether it waits; else how far it goes
    const Relation* relation;
  };
  /// Up to where its leader may go without the next row of `who`.
  double row_of(std::span<const Member> members, int who, const Leader& leader) const {
    const double row = rows_.empty() ? next_of(members, who) : rows_[static_cast<std::size_t>(who)];
    return leader.relation->reads && !lands_at_.empty()
               ? std::min(row, earliest_event(members, who, leader.who, leader.waits))
               : row;
  }
  double earliest_row(std::span<const Member> members, int who) const;
  double earliest_event(std::span<const Member> members, int who, int leader, bool waits) const;
  void look_again(std::span<const Member> members, int who);
  void link();
  void gather(std::span<const int> order);
  void gather_clusters();
  void gather_events(std::span<const int> order);
  Relation::Waits waits_of(std::span<const Member> members, const Neighbour& n, int who) const;
  void change(std::span<const Member> members, int who, const Neighbour& n, Relation::Waits to);
  void mark(std::span<const Member> members, int who);
  int waiting_mate(std::span<const Member> members, int who) const;
  bool mate_waits(std::span<const Member> members, int who) const {
    return !clusters_.empty() && waiting_mate(members, who) >= 0;
  }
  std::span<const int> out_of_rings(std::span<const Member> members);
  std::span<const int> out_of_clusters(std::span<const Member> members);
  int earliest_of(std::span<const Member> members, const Group& group) const;
  std::optional<Neighbour> first_waited_for(std::span<const Member> members, int who) const;
  int out_of_ring(std::span<const Member> members, int from);
  int open_ring();
  std::size_t freed_of_ring(std::size_t begin) const;

  std::vector<Relation> relations_;
  TimeTolerance tolerance_;
  std::vector<Neighbour> neighbours_;  ///< Of one member after the other, each in the order of relations.
  std::vector<std::size_t> first_;     ///< Of a member's neighbours; and the end.
  std::vector<Relation::Waits> waiting_side_;  ///< By relation.
  std::vector<int> waits_;                     ///< By member: relations in which it waits.
  std::vector<double> rows_;  ///< By member: see earliest_row(); empty where these are its next nodes.
  std::vector<std::vector<int>> lands_at_;  ///< By member: leaders at whose events it ends steps; or empty.
  std::vector<std::size_t> place_;          ///< By member: in the order.
  std::vector<std::uint64_t> ready_;        ///< Bits by member: neighbours in memory go one after the other.
  std::vector<Group> groups_;
  std::vector<int> group_of_;               ///< By member.
  std::vector<std::vector<int>> clusters_;  ///< Sampled ones that read each other.
  std::vector<int> cluster_of_;             ///< By member; -1: none. Empty without clusters.
  bool drift_ = false;                      ///< Some could leave the others far behind.
  Earliest earliest_;                       ///< Of the next nodes, where they could.

  std::vector<int> waiting_;  ///< Groups that may all wait.
  std::vector<int> out_of_rings_;
  std::vector<Neighbour> chain_;  ///< Who waits for whom.
  std::vector<char> in_chain_;    ///< By member.
  std::vector<int> freed_;        ///< Relations in which nobody waits any more.
};

}  // namespace tandem
