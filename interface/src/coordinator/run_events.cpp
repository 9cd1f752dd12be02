// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who has events, who reads them, and who may have passed one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "run_start.hpp"

namespace tandem {
namespace {

void add_once(std::vector<int>& to, int who) {
  if (std::find(to.begin(), to.end(), who) == to.end()) to.push_back(who);
}

}  // namespace

/// order: leaders first, of those that go in turns.
void RunStart::note_events(const std::vector<int>& order) {
  using Kind = Schedule::Kind;
  const Kind schedule = run_.coordination_.schedule;
  const auto place = [&](int who) { return std::find(order.begin(), order.end(), who) - order.begin(); };
  std::vector<std::pair<int, int>> told;
  for (const Line& line : topology_.lines()) {
    const int reader = line.reader, source = line.source;
    const Abilities& a = topology_.info(reader).abilities;
    if (!topology_.info(source).abilities.events || a.sampled || reader == source) continue;
    if (schedule == Kind::staggered) continue;
    run_.has_events_ = true;
    add_once(run_.events(source).readers, reader);
    if (schedule == Kind::parallel || place(reader) > place(source)) continue;
    const bool lands = std::isfinite(times_.shortest_period[static_cast<std::size_t>(reader)]);
    if (a.saves_state && lands) {
      add_once(run_.events(reader).events_behind, source);
      add_once(run_.events(source).leaders_back, reader);
    }
    if (std::find(told.begin(), told.end(), std::pair(reader, source)) == told.end())
      note_follower(source, reader, a.saves_state && lands);
    told.emplace_back(reader, source);
  }
  run_.lands_elsewhere_ = run_.has_samples_ || run_.has_events_;
  run_.frozen_ = run_.lands_elsewhere_ && schedule == Kind::parallel;
}

/// What a leader gave past the last node of one with events, it may still take back: those that read it and
/// come later in the order, or are sampled, wait for that one.
void RunStart::wait_for_events(const std::vector<int>& order, std::vector<Read>& reads) const {
  const auto place = [&](int who) { return std::find(order.begin(), order.end(), who) - order.begin(); };
  for (const Read& r : std::vector(reads))
    for (const int other : run_.events(r.source).events_behind) {
      if (r.reader == other || (!sampled(r.reader) && place(r.reader) < place(other))) continue;
      const bool lands = sampled(r.reader) && topology_.info(r.reader).sampling.period >=
                                                  times_.shortest_period[static_cast<std::size_t>(other)];
      reads.push_back({r.reader, other, r.lag, false, lands});
    }
}

void RunStart::note_follower(int who, int leader, bool goes_back) const {
  const std::string name = "'" + topology_.name(who) + "'", ahead = "'" + topology_.name(leader) + "'";
  run_.notes_.push_back("subsystem " + ahead + " reads " + name + ", which has events, and leads it: it " +
                        (goes_back
                             ? "takes one own step a turn, and goes back to events that it has passed"
                             : "can't go back to events that it has passed, and errs to first order there") +
                        "; it need not where " + name + " leads (coordination.order)");
}

}  // namespace tandem
