// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "tandem/coordinator/link.hpp"
#include "tandem/coordinator/topology.hpp"

namespace tandem {

/// Lags of a run [s]: those of `memory` by reader, that of `delay`.
struct Lags {
  std::vector<double> memory;
  double delay = 0.0;
};

/// What passes between the subsystems of a run: the recent samples of each, and the signals made from them.
/// Subsystem i appends to history(i), commit(i) makes that visible, inputs(j) gives what j reads.
class Exchange {
 public:
  /// capacities: rows of memory by subsystem, to begin with. `topology` must outlive the exchange.
  Exchange(const Topology& topology, TimeTolerance tolerance, const Lags& lags,
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

  /// The inputs of `reader` for a call that begins at `time`, with an own step to `next_time`. Valid until
  /// the next commit of one of its sources or the next call of inputs() for it.
  std::span<const Signal> inputs(int reader, double time, double next_time) {
    End& end = ends_[static_cast<std::size_t>(reader)];
    for (Link* link : end.in) link->read(time, next_time, end.slots.data());
    for (Sum& sum : end.sums) add_up(sum, end.slots);
    return {end.slots.data(), end.inputs};
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
  };
  /// What one subsystem gives and reads.
  struct End {
    History history;
    std::vector<Link*> out, in;
    std::size_t inputs;
    std::vector<Signal> slots;  ///< the inputs, then the terms of sums
    std::vector<Sum> sums;
    std::vector<Segment> constants;
  };
  Link& link_for(const Line& line, const Lags& lags, std::vector<std::size_t>& of_pair);
  void add_line(const Topology& topology, const Line& line, const Lags& lags,
                std::vector<std::size_t>& of_pair);
  void hold_start_values(const Topology& topology, int reader);
  static void add_up(Sum& sum, std::span<Signal> slots);

  TimeTolerance tolerance_;
  std::vector<Link> links_;
  std::vector<End> ends_;
};

}  // namespace tandem
