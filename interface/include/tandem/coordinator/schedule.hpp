// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "tandem/coordinator/turn_order.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// One subsystem's share of a round: advance to `limit`; with `land`, cut the last step to end there.
struct Turn {
  int who;
  double limit;
  bool land;
};

/// Who advances next and up to where: a pure function of the clocks.
class Schedule {
 public:
  enum class Kind { slowest_first, fastest_first, staggered, parallel };
  /// From "slowest-first", "fastest-first", "staggered", "parallel"; throws Error(invalid_argument)
  /// otherwise.
  static Kind parse(std::string_view text);
  static std::string_view name(Kind kind);

  /// What it goes by, beside the members.
  struct Plan {
    Kind kind;
    /// Members that integrate themselves; the one that is ahead of all others comes first (slowest-first: own
    /// steps descending; fastest-first: ascending).
    std::vector<int> order;
    TimeSpan span;
    /// [s]: of parallel; in turns, how far subsystems that do not wait for each other may be apart.
    double communication_step;
    /// The member at whose own nodes, as long as it goes, parallel has its communication points: they are
    /// multiples of communication_step from its next node on; -1: from the start on.
    int pace = -1;
    std::vector<int> sampled = {};  ///< sampled members, in an order that the scenario's file does not decide
    bool has_breaks = false;        ///< members end steps where their inputs are known to jump or bend
    std::vector<double> rounds_end_at = {};  ///< [s], ascending: communication points of parallel besides
  };

  /// reads: who reads whom. The members stand nowhere until stand().
  Schedule(Plan plan, std::vector<Member> members, std::span<const Read> reads);

  Kind kind() const { return plan_.kind; }
  std::span<const int> order() const { return plan_.order; }
  const Member& member(int who) const { return members_[static_cast<std::size_t>(who)]; }

  double stop() const { return plan_.span.stop; }  ///< [s]
  /// The run ends at `stop` [s] from now on. All members are to be put anew.
  void stop_at(double stop);

  /// Puts a member where its subsystem stands. It takes no further part if it stands at t_stop, if its next
  /// step would end past it, or if it says so (next = never). It also lands at the next instants of the
  /// sampled members that say so; for that the members that these move are to be put anew.
  /// - break_at [s]: where a held input that it is to land at is known to change next, or another input to
  ///   have jumped.
  /// - jumped: see Member.
  void stand(int who, double time, double next, double break_at = Member::never, bool jumped = false) {
    Member& m = members_[static_cast<std::size_t>(who)];
    m.jumped = jumped;
    if (who == plan_.pace && next != Member::never) pace_node_ = next;
    if (m.lands && next != Member::never) next = std::min(next, plan_.span.stop);
    const bool finished = (time >= earliest_stop_ && !m.sampled) || next > latest_stop_;
    if (landings_ && !finished) next = std::min(next, find_landing(who, time, break_at));
    m.time = finished ? Member::never : time;
    m.next = finished ? Member::never : next;
    if (related_) turns_.moved(members_, who);
  }

  /// The turns of the next round, at most one for each subsystem; none when all have finished. The turns of a
  /// round read the samples as they were when the round began: in turns (slowest-first, fastest-first) none
  /// of them reads another. A limit is never before the member's next node, and past t_stop only where that
  /// node is, by rounding. In parallel a member goes on until its next step would end past `limit`, in as
  /// many calls as it takes. A sampled member acts at its next instant. The span is valid until the next
  /// call.
  std::span<const Turn> next_round();
  /// In parallel with sampled members, or with events: who can go on to the same communication point now that
  /// these have acted, or those have gone; who has events goes first. None: the round is over.
  std::span<const Turn> rest_of_round();
  /// In parallel the communication point of this round is not past `time` [s].
  void end_round_at(double time) { target_ = std::min(target_, time); }

  /// Calls visit(other) for each whose turns depend on where a sampled member stands.
  template <class Visit>
  void each_neighbour(int sampled, const Visit& visit) const {
    turns_.each_neighbour(sampled, visit);
  }

 private:
  double find_landing(int who, double time, double break_at);
  void stagger();
  void turn_of_pair();
  bool add_samples();
  double communication_point() const;
  double communication_point(double first) const;
  void add_up_to(double target);
  template <class Takes>
  void add_those(double target, const Takes& takes);
  void add(int who, double limit);

  Plan plan_;
  std::vector<Member> members_;
  bool in_turns_;
  bool sampled_;   ///< there are sampled members
  bool events_;    ///< there are some with events
  bool landings_;  ///< members end steps elsewhere than at their own nodes
  bool pair_;      ///< two that are linked
  bool related_;   ///< turns_ is kept
  TimeTolerance tolerance_;
  double earliest_stop_ = 0.0, latest_stop_ = 0.0;  ///< t_stop, give and take the tolerance
  TurnOrder turns_;
  double pace_node_ = 0.0;  ///< where the own step of plan_.pace ends, or its last one did [s]
  std::vector<Turn> round_;
  double target_ = 0.0;    ///< of the present round, in parallel
  std::size_t count_ = 0;  ///< turns of the present round
};

}  // namespace tandem
