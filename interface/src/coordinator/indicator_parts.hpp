// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <deque>
#include <span>
#include <vector>

#include "coupling_indicator.hpp"

namespace tandem {

/// What Indicators are made of.
class Indicators::Parts {
 public:
  /// A line's place among what its reader reads.
  struct Lane {
    std::size_t slot;
    LineDefect* defect;
  };

  Parts(const Coordinator& run, const std::vector<PowerLink>& links, const std::vector<int>& left_out);

  /// Of a run whose first samples are at t_start [s]; once.
  void begin(double t_start);
  void samples(int subsystem, const History& history, std::int64_t first, std::int64_t last);
  void acted(int subsystem, double t);
  std::span<const Lane> lanes_of(int reader) const { return lanes_[static_cast<std::size_t>(reader)]; }

  /// Looks at all that is known by now.
  void settle_all();
  const std::vector<Connection>& connections() const { return connections_; }
  const std::vector<Link>& links() const { return links_; }
  std::vector<double> times() const;

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  bool sampled(int who) const { return run_.topology().info(who).abilities.sampled; }
  OutputTrack& track(int who) { return tracks_[static_cast<std::size_t>(who)]; }
  void add_line(Connection& told);
  LineDefect* defect_of(int line);
  void add_link(Link& link);
  CouplingIndicator& coupling(int a, int b);
  SamplingIndicator& sampling(int source, int reader);
  void choose_windows(double t_start);
  void settle(int subsystem);
  TrackEnd end(int who);
  std::int64_t needed(int subsystem) const;

  static constexpr std::int64_t rows_at_a_time =
      32;  ///< of a subsystem: what a look costs beside them is shared

  const Coordinator& run_;
  std::vector<Connection> connections_;
  std::vector<Link> links_;
  Windows windows_;
  std::vector<OutputTrack> tracks_;       ///< by subsystem
  std::vector<std::int64_t> unsettled_;   ///< likewise: rows since the last look
  std::deque<LineDefect> defects_;        ///< as connections_
  std::vector<std::vector<Lane>> lanes_;  ///< by reader
  std::deque<CouplingIndicator> couplings_;
  std::deque<SamplingIndicator> samplings_;
  std::vector<std::vector<CouplingIndicator*>> couplings_of_;  ///< by subsystem
  std::vector<std::vector<SamplingIndicator*>> samplings_of_;  ///< likewise
};

}  // namespace tandem
