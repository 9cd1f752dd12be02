// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"

namespace tandem {

/// False if it is there.
bool add_once(std::vector<int>& to, int who);

/// Everything before the first round: first samples, order, checks of the scheme, memory, seeds.
class RunStart {
 public:
  explicit RunStart(Coordinator& run);
  void make();

 private:
  bool sampled(int who) const { return topology_.info(who).abilities.sampled; }
  /// [s]: no more than that do own steps differ as times in the span are rounded.
  double rounding() const { return run_.tolerance_.width(run_.t_stop_, 0.0); }
  void first_samples();
  void note_steps();
  void note_period(int who);
  void check_span(int who) const;
  void lend_steps();
  double nearest_node(int who) const;
  double largest_step() const;
  int slowest() const;
  void note_times(double communication_step);
  double shortest_period(int who) const;
  Landing landing_of(int who) const;
  bool meets_samples(const Line& line) const;
  bool lands(const Line& line) const;
  bool lands(const Watch& watch) const;
  void note_landing() const;
  void note_missed(int who, const std::vector<int>& others) const;
  void note_missed(int who, const std::string& what) const;
  void note_multiplied(int who, const std::vector<int>& others) const;
  template <class Visit>
  void each_driven(int who, const Visit& visit) const;
  struct KnownJumps {
    std::vector<std::vector<double>> of_inputs, of_outputs;  ///< by subsystem, ascending [s]
  };
  KnownJumps known_jumps() const;
  bool outputs_jump(int who) const;
  std::vector<double> within_span(std::vector<double> times) const;
  bool are_too_many(int who, const std::vector<double>& times) const;
  std::vector<double> breaks_of(int who, const std::vector<double>& jumps) const;
  void note_driven();
  std::vector<Member> members() const;
  double lag_of(const Line& line) const;
  std::vector<Read> reads() const;
  void note_samples(const std::vector<Read>& reads);
  void note_events(const std::vector<int>& order);
  void wait_for_events(std::vector<Read>& reads) const;
  /// Who reads one with events, by itself or by one that jumps with it.
  struct ReadEvents {
    int source, reader, by;
  };
  void note_reader(const ReadEvents& what, const std::vector<int>& order);
  void note_carriers(int source, const std::vector<int>& order);
  void note_follower(const ReadEvents& what, bool goes_back) const;
  void order_outputs();
  std::vector<char> jump_with_inputs() const;
  bool jumps_through(const Line& line) const;
  std::vector<int> reached_at_once(const Line& line) const;
  void note_watches();
  void add_watch(const Watch& watch);
  void end_steps_beside(int who);
  void add_watched(std::vector<Read>& reads) const;
  void add_sources_behind(std::vector<Read>& reads) const;
  void note_followers();
  void note_through();
  void stand_all();
  /// The place of one among equal own steps.
  enum class Tie { jumps, plain, feeds_through, unread };
  Tie tie(int who) const;
  bool is_read(int who, std::optional<int> output = {}) const;
  std::vector<int> sources_first(std::span<const int> group) const;
  std::vector<std::vector<int>> by_own_steps() const;
  std::vector<int> leaders_first() const;
  std::vector<int> sampled_by_name() const;
  bool read_each_other(const std::vector<int>& group) const;
  void note_tie(const std::vector<int>& group) const;
  void check_named_order() const;
  void check_schemes(const std::vector<int>& order) const;
  void note_empty_means(const Line& line) const;
  bool misses_middle(int fast, int slow) const;
  void note_without_effect() const;
  void measure_batches();
  std::vector<std::int64_t> capacities(const std::vector<int>& seeds) const;
  void open_exchange(const std::vector<int>& seeds);

  StartKind choose();
  /// (A sampled reader at whose instants its source ends steps reads samples alone.)
  bool seeds_needed(const Line& line) const {
    return line.how.follows_samples() && line.how.derivatives_at_start() > 0 &&
           !(sampled(line.reader) && lands(line));
  }
  std::string lacks_derivatives() const;
  std::string does_not_repeat() const;
  void note_cold(const std::string& why) const;
  std::vector<int> seeds() const;
  std::vector<double> row_at(int who, const std::vector<double>& times, double t) const;
  std::vector<double> past_of(int who, int count) const;
  void seed_from_passes();
  struct FirstSteps {
    int passes, round;      ///< a change has come round after so many of them
    double until, largest;  ///< [s]: where they end, and the longest own step
  };
  FirstSteps first_steps() const;
  void repeat();
  bool jumped() const;
  void give_up(const std::string& why);
  void set_passes_apart();
  Clock start_again(int who);
  void pass(int who, Exchange& before, double until);

  Coordinator& run_;
  const Topology& topology_;
  std::vector<std::vector<double>> rows_;  ///< by subsystem: its first sample, header left out
  std::vector<Clock> clocks_;              ///< by subsystem: as it was initialized
  std::vector<std::vector<double>> u0_;    ///< by subsystem: the inputs that it was initialized with
  std::vector<std::vector<double>> past_;  ///< by subsystem: rows before the start; empty: derivatives tell
  LinkTimes times_;
  std::vector<char> jumps_;  ///< by subsystem: outputs that follow its inputs at once may jump
  bool has_breaks_ = false;            ///< LinkTimes::breaks
  std::vector<double> rounds_end_at_;  ///< [s]: where outputs are known to jump
};

}  // namespace tandem
