// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "tandem/coordinator/driven.hpp"
#include "tandem/coordinator/link.hpp"
#include "tandem/coordinator/topology.hpp"

namespace tandem {

/// A change of this output of a sampled one at t may be a jump, at t + lag [s], of what `reader` reads of others that follow
/// it at once.
struct Watch {
  int reader, source, output;
  double lag;
};

/// Times of a run that links go by [s].
struct LinkTimes {
  std::vector<double> memory;  ///< by reader: of lines with a memory
  double delay = 0.0;          ///< of lines with a delay
  /// By source: what Link::pass_over is told; 0 for those that end steps at their own nodes alone. Empty:
  /// all.
  std::vector<double> nearest = {};
  /// By reader: the shortest period of sampled sources at whose samples it ends a step. Empty: at none.
  std::vector<double> shortest_period = {};
  /// By subsystem: a number that is the same for those that depend on each other. Empty: as if all did.
  std::vector<int> loop = {};
  /// By subsystem: outputs that follow its inputs at once may jump with events of another. Empty: none may.
  std::vector<char> carries = {};
  /// By reader, ascending: where it ends a step, as an input is known to jump or bend there. Empty: nowhere.
  std::vector<std::vector<double>> breaks = {};
  std::vector<Watch> watches = {};
};

/// What passes between the subsystems of a run: the recent samples of each, and the signals made from them.
/// Subsystem i appends to history(i), commit(i) makes that visible, inputs(j) gives what j reads. Its header is
/// long, as what a turn calls stands in it.
class Exchange {
 public:
  /// Of a run from t_start [s] on. capacities: rows of memory by subsystem, to begin with. `topology` must
  /// outlive the exchange.
  Exchange(const Topology& topology, double t_start, const LinkTimes& times,
           std::span<const std::int64_t> capacities);
  Exchange(Exchange&&) = default;
  Exchange& operator=(Exchange&&) = default;

  History& history(int subsystem) { return ends_[static_cast<std::size_t>(subsystem)].history; }
  const History& history(int subsystem) const { return ends_[static_cast<std::size_t>(subsystem)].history; }

  /// Checks the rows that `source` appended (History::commit) and makes their segments. Returns their number.
  std::int64_t commit(int source, double t_limit) {
    End& end = ends_[static_cast<std::size_t>(source)];
    const NewRows rows = end.history.commit(t_limit, tolerance_);
    for (Link* link : end.out) link->extend(rows);
    return rows.count;
  }

  /// commit() in two halves: what sampled readers see, and then, of all that was accepted, what others see.
  std::int64_t accept(int source, double t_limit);
  void publish(int source);

  /// The outputs of `source` that follow its inputs will jump at t: next_break() of their readers knows of
  /// it.
  void expect_jump(int source, double t) {
    for (Link* link : ends_[static_cast<std::size_t>(source)].out) link->expect_jump(t);
  }
  /// Calls visit(reader) for each that reads `source`; more than once for one that does so by several links.
  template <class Visit>
  void each_reader(int source, const Visit& visit) const {
    for (const Link* link : ends_[static_cast<std::size_t>(source)].out) visit(link->reader());
  }
  /// A jump of inputs: the largest, and where the first is seen [s].
  struct Jump {
    double size = 0.0, time = Member::never;
    void add(const Jump& other) { size = std::max(size, other.size), time = std::min(time, other.time); }
  };
  /// That at the newest row of `source` which inputs of `reader` see before `until`; size 0 for none.
  Jump jump(int source, int reader, double until) const;
  /// Takes the newest `rows` rows of `source` back.
  void withdraw(int source, std::int64_t rows);
  /// `reader` may go back to `time` [s], but no further: make_room() keeps what it needs for that.
  void keep_from(int reader, double time) { ends_[static_cast<std::size_t>(reader)].keep_from = time; }
  /// It has gone back.
  void rebuild(int reader);

  /// The newest row of a sampled source has other values now than when it was committed.
  void remake_newest(int source);

  /// The inputs of `reader` for a call from `time` to `limit`, with a first own step to `next_time`. Valid
  /// at times up to `limit`, until the next commit of one of its sources or the next call of inputs() for it.
  std::span<const Signal> inputs(int reader, double time, double next_time, double limit) {
    End& end = ends_[static_cast<std::size_t>(reader)];
    for (Link* link : end.in) link->read(time, next_time, end.slots.data());
    if (end.has_more) {
      for (Sum& sum : end.sums) add_up(sum, end.slots, limit);
      for (Driven& input : end.driven) end.slots[input.slot()] = input.over(time, limit);
    }
    return {end.slots.data(), static_cast<std::size_t>(end.inputs)};
  }

  /// An open input (Topology::is_open). Valid as long as the exchange is where it is.
  Driven& open_input(int reader, int input);
  /// It has read the jumps of its open inputs where it stands.
  void forget_jumps(int reader);

  /// What the reader got last: its inputs, and behind them the terms of those that are sums. Valid as what inputs() and
  /// sample() give.
  std::span<const Signal> lanes(int reader) const { return ends_[static_cast<std::size_t>(reader)].slots; }
  std::span<const double> values(int reader) const { return ends_[static_cast<std::size_t>(reader)].values; }
  /// The place of a line of the topology among these.
  std::size_t slot(int line) const { return slots_of_lines_[static_cast<std::size_t>(line)]; }

  /// The inputs of a sampled `reader` at its instant `to.stop`, having acted at `to.start`. Valid until the
  /// next call for it.
  std::span<const double> sample(int reader, TimeSpan to);

  /// When an input of `reader`, which stands at `time`, and ends a step there, is known to change next;
  /// `never` if that is not known.
  double next_break(int reader, double time) const;
  /// Whether what one that stands at `time` reads of others jumps there, which it has not read yet.
  bool jumps_unread(int reader, double time) const {
    const End& end = ends_[static_cast<std::size_t>(reader)];
    return std::any_of(end.in.begin(), end.in.end(),
                       [time](const Link* link) { return link->jumps_at(time); });
  }
  /// The same, or data that it reads jump there.
  bool jumps_at(int reader, double time) const {
    const End& end = ends_[static_cast<std::size_t>(reader)];
    return jumps_unread(reader, time) || std::any_of(end.driven.begin(), end.driven.end(),
                                                     [time](const Driven& d) { return d.jumps_at(time); });
  }

  /// Makes room for `wanted` rows of `source`: drops what no reader, standing at its newest sample, needs any
  /// more.
  void make_room(int source, std::int64_t wanted);

  /// From now on the signals begin with the first segment of full degree (see Link::reach_back).
  void reach_back();

  /// Histories and links, for a checkpoint, and back into the exchange of a run that is put together alike.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

  std::span<const Link> links() const { return links_; }

 private:
  /// An input that is the sum of several lanes.
  struct Sum {
    std::size_t input, first, count;  ///< slots
    std::vector<Segment> segments;
    std::vector<char> jumps;  ///< by segment
  };
  /// What one subsystem gives and reads.
  struct alignas(64) End {
    End(History own, std::size_t count)
        : history(std::move(own)), inputs(static_cast<std::int32_t>(count)), slots(count) {}
    History history;
    // What a turn touches, in one line of the cache, up to where the slots are.
    std::vector<Link*> out, in;  ///< out: those to sampled readers first
    std::int32_t inputs;
    bool has_more = false;      ///< there are sums, or driven inputs
    std::vector<Signal> slots;  ///< the inputs, then the terms of sums, and what it watches
    std::vector<Sum> sums;
    std::vector<Driven> driven;
    std::size_t at_instants = 0;  ///< links of `out`
    std::vector<Segment> constants;
    std::vector<const Link*> breaks;   ///< of in, those at whose breaks it ends a step
    std::vector<double> known_breaks;  ///< LinkTimes::breaks
    std::vector<double> values;        ///< of a sampled one: the inputs, then the terms of sums
    double keep_from = Member::never;
  };
  Link& link_for(const Topology& topology, const Line& line, const LinkTimes& times,
                 std::vector<std::size_t>& of_pair);
  void add_line(const Topology& topology, const Line& line, const LinkTimes& times,
                std::vector<std::size_t>& of_pair);
  void add_watch(const Watch& watch);
  void hold_start_values(const Topology& topology, int reader);
  void drive(const Topology& topology, int reader, double t_start);
  void add_up(Sum& sum, std::span<Signal> slots, double limit) const;
  void add_term(Sum& sum, const Signal& term) const;
  double first_jump_end(std::span<const Signal> terms) const;
  void add_pieces(Sum& sum, const Signal& term, double begin) const;
  void add_rest(Sum& sum, std::span<const Signal> terms) const;

  TimeTolerance tolerance_;
  std::vector<Link> links_;
  std::vector<End> ends_;
  std::vector<std::size_t> slots_of_lines_;
};

}  // namespace tandem
