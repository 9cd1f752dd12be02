// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "tandem/coordinator/earliest.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// What a schedule sees of a subsystem.
struct Member {
  static constexpr double never = std::numeric_limits<double>::max();

  double time = never;  ///< where it stands [s]; `never` if it takes no further part
  double next = never;  ///< where its next own step ends [s]; of one that can land, at most t_stop; likewise
  bool lands = false;   ///< can cut a step
  bool reads_mean =
      false;  ///< reads an input that is a mean over its own step, so it takes one step at a time

  bool finished() const { return next == never; }
};

/// `reader` has an input from `source`.
struct Read {
  int reader, source;
};

/// Whose turn it is among subsystems of which some lead others: a pure function of the clocks.
///
/// Two are linked if one reads the other; the one that is earlier in the order leads. It is the follower's
/// turn if the leader stands at or past the end of the follower's next step, so that the follower
/// interpolates; else it is the leader's. A member is ready when it is its turn in each of its pairs. Of two
/// that are linked never both are ready, and each step reads the same samples whatever goes first elsewhere:
/// a leader's those of the follower up to where the leader stands, a follower's those of the leader up to the
/// first one at or past the end of that step. Those that have nothing to do with each other do not wait for
/// each other.
///
/// Three and more can wait in a ring: A leads B and C, B leads C; C waits for B to pass its node, B for A to
/// pass its own, and A, which stands past C's node, for C. When all of a group that is linked wait, go from
/// the one with the earliest node to the first in the order that it waits for, on to the first that this one
/// waits for, and so on until the ring is closed: the first leader of the ring goes without the sample of the
/// follower that it waits for there. (So do subsystems that all read all, in the order of coordinator.md.)
class TurnOrder {
 public:
  TurnOrder() = default;
  /// order: leaders first. reads: in any number and order.
  TurnOrder(std::vector<int> order, std::span<const Read> reads, TimeTolerance tolerance);

  std::span<const int> order() const { return order_; }

  /// One of the members stands elsewhere now.
  void moved(std::span<const Member> members, int who);

  /// Calls take(who, limit) for each that has a turn: it may go up to `limit`, or to its next node where that
  /// is later. Groups that are not linked stay together: who stands further than `ahead` [s] past the
  /// earliest next node of all waits for that.
  template <class Take>
  void each_turn(std::span<const Member> members, double ahead, const Take& take) {
    bool any = false;
    for (const int who : out_of_rings(members)) take(who, next_of(members, who)), any = true;
    const double latest = groups_.size() > 1 ? earliest_.value() + ahead : Member::never;
    if (!each_ready(members, latest, take) && !any) each_ready(members, Member::never, take);
  }

 private:
  struct Neighbour {
    std::int32_t who, pair;
    bool leads;  ///< the neighbour leads
  };
  /// Members that are linked, directly or by others.
  struct Group {
    std::vector<int> members;  ///< in the order
    int ready = 0;
    bool has_rings = false;  ///< more pairs than it takes to link them
    bool waits = false;      ///< is in waiting_
  };

  std::span<const Neighbour> neighbours(int who) const {
    const auto i = static_cast<std::size_t>(who);
    return {neighbours_.data() + first_[i], neighbours_.data() + first_[i + 1]};
  }
  bool waits_for(const Neighbour& other) const {
    return (leaders_turn_[static_cast<std::size_t>(other.pair)] != 0) == other.leads;
  }
  static double next_of(std::span<const Member> members, int who) {
    return members[static_cast<std::size_t>(who)].next;
  }
  void link(std::span<const Read> reads);
  void gather();
  void mark(std::span<const Member> members, int who);
  double limit(std::span<const Member> members, int who) const;
  std::span<const int> out_of_rings(std::span<const Member> members);
  int earliest_of(std::span<const Member> members, const Group& group) const;
  const Neighbour* first_waited_for(int who) const;
  int out_of_ring(int from);
  int open_ring();

  template <class Take>
  bool each_ready(std::span<const Member> members, double latest, const Take& take) const {
    bool any = false;
    for (std::size_t w = 0; w < ready_.size(); ++w)
      for (std::uint64_t bits = ready_[w]; bits != 0; bits &= bits - 1) {
        const int who = static_cast<int>(w * 64) + std::countr_zero(bits);
        if (members[static_cast<std::size_t>(who)].time > latest) continue;
        take(who, limit(members, who));
        any = true;
      }
    return any;
  }

  std::vector<int> order_;
  std::vector<std::size_t> place_;  ///< in the order, by member
  TimeTolerance tolerance_;
  std::vector<Neighbour> neighbours_;  ///< of one member after the other, each in the order
  std::vector<std::size_t> first_;     ///< of a member's neighbours; and the end
  std::vector<char> leaders_turn_;     ///< by pair
  std::vector<int> waits_;             ///< by member: pairs in which it is the other's turn
  std::vector<std::uint64_t> ready_;   ///< bits by member: neighbours in memory go one after the other
  std::vector<Group> groups_;
  std::vector<int> group_of_;  ///< by member
  Earliest earliest_;          ///< of the next nodes, if there are several groups

  std::vector<int> waiting_;  ///< groups that may all wait
  std::vector<int> out_of_rings_;
  std::vector<Neighbour> chain_;  ///< who waits for whom
  std::vector<char> in_chain_;    ///< by member
  std::vector<int> freed_;        ///< pairs of which nobody waits any more
};

}  // namespace tandem
