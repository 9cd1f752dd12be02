// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include "tandem/coordinator/schedule.hpp"

namespace tandem::test {

/// A subsystem as a schedule sees it: a grid of own steps, nothing on it.
struct Walker {
  char name;
  double own_step;
  bool lands = false;
  bool reads_mean = false;
  double finishes = 1e300;  ///< takes no step that ends past this
};

/// Walkers that do what a schedule says, to write down who came where.
class ScheduleBench {
 public:
  ScheduleBench(const std::vector<Walker>& walkers, double t_start, double t_stop)
      : walkers_(walkers),
        t_stop_(t_stop),
        ends_(Schedule::Kind::parallel, {}, {t_start, t_stop}, 1.0),
        tolerance_(t_start) {
    for (const Walker& w : walkers) {
      grids_.emplace_back(t_start, w.own_step);
      members_.push_back({t_start, t_start, w.lands, w.reads_mean});
    }
    for (std::size_t i = 0; i < walkers.size(); ++i) look(i);
  }

  const std::vector<Member>& members() const { return members_; }
  double time(int i) const { return grids_[static_cast<std::size_t>(i)].time(); }
  /// Its clock, whether it has finished or not.
  Member clock(int i) const {
    const auto k = static_cast<std::size_t>(i);
    const Walker& w = walkers_[k];
    const double next = done(k) ? 1e300 : w.lands ? std::min(grids_[k].next(), t_stop_) : grids_[k].next();
    return {time(i), next, w.lands, w.reads_mean};
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
  std::string run(Schedule schedule) {
    std::string log;
    while (true) {
      const auto round = schedule.next_round(members_);
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
  bool done(std::size_t i) const { return tolerance_.before(walkers_[i].finishes, grids_[i].next()); }
  void look(std::size_t i) {
    ends_.stand(members_[i], grids_[i].time(), done(i) ? Member::never : grids_[i].next());
  }

  std::vector<Walker> walkers_;
  double t_stop_;
  Schedule ends_;  ///< says who has finished
  TimeTolerance tolerance_;
  std::vector<TimeGrid> grids_;
  std::vector<Member> members_;
};

}  // namespace tandem::test
