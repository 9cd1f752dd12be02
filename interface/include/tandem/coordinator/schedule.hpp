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

  /// order: indices of the members, that of the one which is ahead of all others first (slowest-first: own
  /// steps descending; fastest-first: ascending). reads: who reads whom. communication_step [s]: of parallel;
  /// in turns, how far unlinked subsystems may be apart. The members stand nowhere until stand().
  Schedule(Kind kind, std::vector<Member> members, std::vector<int> order, std::span<const Read> reads,
           TimeSpan span, double communication_step);

  Kind kind() const { return kind_; }
  std::span<const int> order() const { return turns_.order(); }
  const Member& member(int who) const { return members_[static_cast<std::size_t>(who)]; }

  /// Puts a member where its subsystem stands. It takes no further part if it stands at t_stop, if its next
  /// step would end past it, or if it says so (next = never).
  void stand(int who, double time, double next) {
    Member& m = members_[static_cast<std::size_t>(who)];
    if (m.lands && next != Member::never) next = std::min(next, t_stop_);
    const bool finished = time >= earliest_stop_ || next > latest_stop_;
    m.time = finished ? Member::never : time;
    m.next = finished ? Member::never : next;
    if (in_turns_) turns_.moved(members_, who);
  }

  /// The turns of the next round, at most one for each subsystem; none when all have finished. The turns of a
  /// round read the samples as they were when the round began: in turns (slowest-first, fastest-first) none
  /// of them reads another. A limit is never before the member's next node, and past t_stop only where that
  /// node is, by rounding. In parallel a member goes on until its next step would end past `limit`, in as
  /// many calls as it takes. The span is valid until the next call.
  std::span<const Turn> next_round();

 private:
  void stagger();
  void all_at_once();
  void add(int who, double limit);

  Kind kind_;
  bool in_turns_;
  std::vector<Member> members_;
  double t_start_, t_stop_, communication_step_;
  TimeTolerance tolerance_;
  double earliest_stop_, latest_stop_;  ///< t_stop, give and take the tolerance
  TurnOrder turns_;
  std::vector<Turn> round_;
  std::size_t count_ = 0;  ///< turns of the present round
};

}  // namespace tandem
