// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who has events, who reads them, and who may have passed one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "feedthrough.hpp"
#include "run_start.hpp"

namespace tandem {

bool add_once(std::vector<int>& to, int who) {
  if (std::find(to.begin(), to.end(), who) != to.end()) return false;
  to.push_back(who);
  return true;
}

/// order: leaders first, of those that go in turns.
void RunStart::note_events(const std::vector<int>& order) {
  const Schedule::Kind schedule = run_.coordination_.schedule;
  times_.carries.assign(clocks_.size(), 0);
  for (const Line& line : topology_.lines())
    if (topology_.info(line.source).abilities.events && !sampled(line.reader) && line.reader != line.source)
      note_reader({line.source, line.reader, line.source}, order);
  for (int i = 0; i < topology_.size() && schedule != Schedule::Kind::staggered; ++i)
    if (!run_.events(i).readers.empty()) note_carriers(i, order);
  run_.lands_elsewhere_ = run_.has_samples_ || run_.has_events_ || has_breaks_;
  run_.frozen_ = run_.lands_elsewhere_ && schedule == Schedule::Kind::parallel;
}

void RunStart::note_reader(const ReadEvents& what, const std::vector<int>& order) {
  const auto [source, reader, by] = what;
  const Schedule::Kind schedule = run_.coordination_.schedule;
  if (schedule == Schedule::Kind::staggered)
    return run_.notes_.push_back("schedule staggered ends no step of subsystem '" + topology_.name(reader) +
                                 "' where '" + topology_.name(source) + "' has an event");
  run_.has_events_ = true;
  if (!add_once(run_.events(source).readers, reader)) return;
  const auto place = [&](int who) { return std::find(order.begin(), order.end(), who) - order.begin(); };
  if (schedule == Schedule::Kind::parallel || place(reader) > place(source)) return;
  const bool goes_back = topology_.info(reader).abilities.saves_state &&
                         std::isfinite(times_.shortest_period[static_cast<std::size_t>(reader)]);
  if (goes_back) {
    add_once(run_.events(reader).events_behind, source);
    add_once(run_.events(source).leaders_back, reader);
  }
  note_follower(what, goes_back);
}

/// Those whose outputs jump with the outputs of one with events, and who reads these.
void RunStart::note_carriers(int source, const std::vector<int>& order) {
  auto& carriers = run_.events(source).carriers;
  const auto carries = [&](const Line& line) {
    return line.lag == Lag::none && !sampled(line.reader) && line.reader != source &&
           (line.source == source ||
            (std::find(carriers.begin(), carriers.end(), line.source) != carriers.end() &&
             follows(topology_.info(line.source), line.output)));
  };
  for (bool more = true; more;) {
    more = false;
    for (const Line& line : topology_.lines())
      if (carries(line) && feeds(topology_.info(line.reader), line.input))
        more = add_once(carriers, line.reader) || more;
  }
  for (const Line& line : topology_.lines())
    if (line.source != source && carries(line) && line.reader != line.source) {
      times_.carries[static_cast<std::size_t>(line.source)] = 1;
      times_.nearest[static_cast<std::size_t>(line.reader)] = nearest_node(line.reader);
      add_once(run_.events(source).of_carriers, line.reader);
      note_reader({source, line.reader, line.source}, order);
    }
}

/// What a leader gave past the last node of one with events, it may still take back: who reads it goes in
/// turns with that one, so that what it reads does not depend on who went first elsewhere; where it comes
/// later in the order, or is sampled, it waits. So does who reads what jumps with an event.
void RunStart::wait_for_events(std::vector<Read>& reads) const {
  const auto is_there = [&](const Read& r) {
    return std::any_of(reads.begin(), reads.end(), [&](const Read& known) {
      return known.reader == r.reader && known.source == r.source && known.lag == r.lag;
    });
  };
  for (std::size_t k = 0; k < reads.size(); ++k)  // of those that are added too
    for (const int other : run_.events(reads[k].source).events_behind) {
      Read r = reads[k];
      r.source = other, r.just_before = false;
      r.lands = sampled(r.reader) && r.lag <= r.period + rounding() &&
                r.period >= times_.shortest_period[static_cast<std::size_t>(other)];
      if (r.reader != other && !is_there(r)) reads.push_back(r);
    }
  for (int i = 0; i < topology_.size(); ++i)
    for (const int reader : run_.events(i).readers) {
      const bool lands = std::isfinite(times_.shortest_period[static_cast<std::size_t>(reader)]);
      reads.push_back({reader, i, 0.0, false, lands});
    }
}

void RunStart::note_follower(const ReadEvents& what, bool goes_back) const {
  const auto quoted = [this](int i) { return "'" + topology_.name(i) + "'"; };
  const std::string name = quoted(what.source),
                    which = what.by == what.source
                                ? ", which has events, and leads it: it "
                                : ", which jumps with events of " + name + ", and leads " + name + ": it ";
  run_.notes_.push_back("subsystem " + quoted(what.reader) + " reads " + quoted(what.by) + which +
                        (goes_back
                             ? "takes one own step a turn, and goes back to events that it has passed"
                             : "can't go back to events that it has passed, and errs to first order there") +
                        "; it need not where " + name + " leads (coordination.order)");
}

}  // namespace tandem
