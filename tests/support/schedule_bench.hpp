// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tandem/coordinator/schedule.hpp"

namespace tandem::test {

/// A subsystem as a schedule sees it: a grid of own steps, nothing on it.
struct Walker {
  char name;
  double own_step;
  bool lands = false;
  bool one_step = false;
  double finishes = 1e300;  ///< takes no step that ends past this
};

inline std::vector<Read> all_read_all(std::size_t count) {
  std::vector<Read> reads;
  for (int i = 0; i < static_cast<int>(count); ++i)
    for (int j = 0; j < static_cast<int>(count); ++j)
      if (i != j) reads.push_back({i, j});
  return reads;
}

/// Walkers that do what a schedule says, to write down who came where.
class ScheduleBench {
 public:
  ScheduleBench(const std::vector<Walker>& walkers, Schedule::Kind kind, std::vector<int> order,
                TimeSpan span, double communication_step, const std::vector<Read>& reads)
      : walkers_(walkers),
        t_stop_(span.stop),
        tolerance_(span.start),
        schedule_(
            {.kind = kind, .order = std::move(order), .span = span, .communication_step = communication_step},
            members(walkers), reads) {
    for (const Walker& w : walkers) grids_.emplace_back(span.start, w.own_step);
    for (std::size_t i = 0; i < walkers.size(); ++i) look(i);
  }

  Schedule& schedule() { return schedule_; }
  double time(int i) const { return grids_[static_cast<std::size_t>(i)].time(); }
  /// Its clock, whether it has finished or not.
  Member clock(int i) const {
    const auto k = static_cast<std::size_t>(i);
    const Walker& w = walkers_[k];
    const double next = done(k) ? 1e300 : w.lands ? std::min(grids_[k].next(), t_stop_) : grids_[k].next();
    return {.time = time(i), .next = next, .lands = w.lands, .one_step = w.one_step};
  }

  /// Takes a turn, as FixedStep does; in parallel this is all the calls of a round.
  void take(const Turn& turn) {
    const auto i = static_cast<std::size_t>(turn.who);
    while (grids_[i].fits(turn.limit) && !done(i)) grids_[i].step();
    if (turn.land && grids_[i].cuts(turn.limit)) grids_[i].cut(turn.limit);
    look(i);
  }

  /// Runs to the end: "S2.5 F2 ...", each walker's name and where its turn took it; rounds of several are in
  /// brackets.
  std::string run() {
    std::string log;
    while (true) {
      const auto round = schedule_.next_round();
      if (round.empty()) return log;
      const std::vector<Turn> turns(round.begin(), round.end());
      std::string text;
      for (const Turn& turn : turns) {
        take(turn);
        char place[32];
        std::snprintf(place, sizeof place, "%c%.6g", walkers_[static_cast<std::size_t>(turn.who)].name,
                      time(turn.who));
        text += (text.empty() ? "" : " ") + std::string(place);
      }
      log += (log.empty() ? "" : " ") + (turns.size() > 1 ? "(" + text + ")" : text);
    }
  }

 private:
  static std::vector<Member> members(const std::vector<Walker>& walkers) {
    std::vector<Member> all;
    for (const Walker& w : walkers) all.push_back({.lands = w.lands, .one_step = w.one_step});
    return all;
  }
  bool done(std::size_t i) const { return tolerance_.before(walkers_[i].finishes, grids_[i].next()); }
  void look(std::size_t i) {
    schedule_.stand(static_cast<int>(i), grids_[i].time(), done(i) ? Member::never : grids_[i].next());
  }

  std::vector<Walker> walkers_;
  double t_stop_;
  TimeTolerance tolerance_;
  Schedule schedule_;
  std::vector<TimeGrid> grids_;
};

}  // namespace tandem::test
