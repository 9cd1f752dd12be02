// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "tandem/time_grid.hpp"

namespace tandem {

/// What a schedule sees of a subsystem (Schedule::stand).
struct Member {
  static constexpr double never = std::numeric_limits<double>::max();

  double time;         ///< where it stands [s]; `never` if it takes no further part
  double next;         ///< where its next own step ends [s]; of one that can land, at most t_stop; likewise
  bool lands = false;  ///< can cut a step
  bool reads_mean =
      false;  ///< reads an input that is a mean over its own step, so it takes one step at a time

  bool finished() const { return next == never; }
};

/// One subsystem's share of a round: advance to `limit`; with `land`, cut the last step to end there.
struct Turn {
  int who;
  double limit;
  bool land;
};

/// Who advances next and up to where: pure functions of the clocks. Positions 0, 1, ... are the order in
/// which the subsystems lead: position 0 is ahead of all others (slowest-first: own steps descending;
/// fastest-first: ascending).
class Schedule {
 public:
  enum class Kind { slowest_first, fastest_first, staggered, parallel };
  /// From "slowest-first", "fastest-first", "staggered", "parallel"; throws Error(invalid_argument)
  /// otherwise.
  static Kind parse(std::string_view text);
  static std::string_view name(Kind kind);

  /// order: indices of the subsystems, leader first. communication_step [s]: of parallel only.
  Schedule(Kind kind, std::vector<int> order, TimeSpan span, double communication_step);

  /// reads[i * n + j]: subsystem i reads subsystem j. In turns (slowest-first, fastest-first) a round then
  /// takes in further turns that would come next in any case, of subsystems that neither read nor are read by
  /// the others of the round. Without this call all are taken to read all, so a round is one turn.
  void set_reads(std::vector<char> reads);

  Kind kind() const { return kind_; }
  std::span<const int> order() const { return order_; }

  /// The turns of the next round, at most one for each subsystem; none when all have finished. The turns of a
  /// round read the samples as they were when the round began. A limit is never before the member's next
  /// node, and past t_stop only where that node is, by rounding. In parallel a member goes on until its next
  /// step would end past `limit`, in as many calls as it takes. The span is valid until the next call.
  std::span<const Turn> next_round(std::span<const Member> members);

  /// Puts a member where its subsystem stands. It takes no further part if it stands at t_stop, if its next
  /// step would end past it, or if it says so (next = never).
  void stand(Member& m, double time, double next) const {
    if (m.lands && next != Member::never) next = std::min(next, t_stop_);
    const bool finished = time >= earliest_stop_ || next > latest_stop_;
    m.time = finished ? Member::never : time;
    m.next = finished ? Member::never : next;
  }

 private:
  void take_turns(std::span<const Member> members);
  void take_more_turns(std::span<const Member> members);
  bool is_free(int who, std::size_t count) const;
  void stagger(std::span<const Member> members);
  void all_at_once(std::span<const Member> members);
  void add(int who, const Member& m, double limit);

  Kind kind_;
  std::vector<int> order_;
  double t_start_, t_stop_, communication_step_;
  TimeTolerance tolerance_;
  double earliest_stop_, latest_stop_;  ///< t_stop, give and take the tolerance
  std::vector<char> linked_;            ///< i * n + j: one of the two reads the other; empty: all do
  std::vector<Member> foreseen_;        ///< members as they will stand after the turns of this round
  std::vector<Turn> round_;
  std::size_t count_ = 0;  ///< turns of the present round
};

}  // namespace tandem
