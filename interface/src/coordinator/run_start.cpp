// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "run_start.hpp"

#include <algorithm>
#include <cmath>

#include "../number_text.hpp"
#include "tandem/error.hpp"

namespace tandem {
RunStart::RunStart(Coordinator& run) : run_(run), topology_(run.topology_) {}

void RunStart::make() {
  topology_.check_span({run_.t_start_, run_.t_stop_});
  first_samples();
  note_steps();
  std::vector<int> order = leaders_first();
  check_schemes(order);
  const auto given = run_.coordination_.communication_step;
  const double h = given.value_or(largest_step());
  if (!std::isfinite(h) || h <= 0.0)
    throw Error(ErrorCode::invalid_argument,
                "communication_step is " + number_text(h) + " s; it must be finite and above 0");
  note_times(h);
  note_watches();
  note_driven();
  auto all = reads();
  note_samples(all);
  note_events(order);
  wait_for_events(all);
  note_through();
  run_.schedule_.emplace(Schedule::Plan{run_.coordination_.schedule,
                                        std::move(order),
                                        {run_.t_start_, run_.t_stop_},
                                        h,
                                        given ? -1 : slowest(),
                                        sampled_by_name(),
                                        has_breaks_,
                                        rounds_end_at_},
                         members(), all);
  stand_all();
  measure_batches();
  open_exchange(std::vector<int>(run_.own_steps_.size()));
  if (has_breaks_) run_.place_all();
  note_without_effect();
  note_landing();
  run_.start_ = choose();
  if (run_.start_ == StartKind::derivatives) open_exchange(seeds());
  if (run_.start_ == StartKind::repeat) repeat();
  for (int i = 0; i < topology_.size(); ++i) run_.seat(i).goes_back = !run_.events(i).events_behind.empty();
}

void RunStart::stand_all() {
  for (std::size_t i = 0; i < clocks_.size(); ++i) {
    run_.seats_[i].time = clocks_[i].time;
    run_.own_next_[i] = clocks_[i].stop == Stop::finished ? Member::never : clocks_[i].next_time;
  }
  run_.place_all();
}

/// Of those that integrate themselves, if there are any.
double RunStart::largest_step() const {
  double largest = 0.0, of_sampled = 0.0;
  for (int i = 0; i < topology_.size(); ++i) {
    double& most = sampled(i) ? of_sampled : largest;
    most = std::max(most, run_.own_step(i));
  }
  return largest > 0.0 ? largest : of_sampled;
}

/// Of those that integrate themselves the one with the largest own step; -1: there are none.
int RunStart::slowest() const {
  const auto groups = by_own_steps();
  return groups.empty() ? -1 : groups.back().front();
}

/// What the schedule has to know of them before they stand anywhere.
std::vector<Member> RunStart::members() const {
  std::vector<Member> all(static_cast<std::size_t>(topology_.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].lands = topology_.info(static_cast<int>(i)).abilities.lands;
    all[i].sampled = sampled(static_cast<int>(i));
    all[i].events = !run_.event_seats_[i].readers.empty();
    all[i].one_step = !run_.event_seats_[i].events_behind.empty();
  }
  for (const auto& sources : run_.through_)
    for (const Through& through : sources) all[static_cast<std::size_t>(through.source)].jumps = true;
  for (const Line& line : topology_.lines())
    if (line.how.kind == Reconstruction::Kind::mean)
      all[static_cast<std::size_t>(line.reader)].one_step = true;
  return all;
}

/// Settings that are there and change nothing.
void RunStart::note_without_effect() const {
  const auto& lines = topology_.lines();
  const bool parallel = run_.coordination_.schedule == Schedule::Kind::parallel;
  const bool delays =
      std::any_of(lines.begin(), lines.end(), [](const Line& line) { return line.lag == Lag::delay; });
  if (run_.coordination_.communication_step && !parallel && !delays)
    run_.notes_.push_back("communication_step has no effect: it serves schedule parallel and delays");
  if (!run_.coordination_.order.empty() && parallel && !run_.has_events_)
    run_.notes_.push_back("order has no effect in schedule parallel");
  for (int i = 0; i < topology_.size(); ++i)
    if (sampled(i) && landing_of(i) != Landing::automatic)
      run_.notes_.push_back("land has no effect for subsystem '" + topology_.name(i) +
                            "', which is sampled and has no own steps to end; it is for those that read it");
}

/// Own steps as the subsystems stand.
void RunStart::note_steps() {
  const auto n = static_cast<std::size_t>(topology_.size());
  run_.own_steps_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int who = static_cast<int>(i);
    if (sampled(who)) {
      note_period(who);
      continue;
    }
    run_.own_steps_[i] = clocks_[i].next_time - clocks_[i].time;
    if (clocks_[i].stop != Stop::finished && !(run_.own_steps_[i] > 0.0 && std::isfinite(run_.own_steps_[i])))
      throw Error(ErrorCode::numerical,
                  "subsystem '" + topology_.name(who) + "' gives " + number_text(clocks_[i].next_time) +
                      " s as the end of its first own step, which is not later than the start");
  }
  lend_steps();
  for (std::size_t i = 0; i < n; ++i)
    if (!run_.tolerance_.before(run_.t_stop_ - run_.own_steps_[i], run_.t_stop_))
      throw Error(ErrorCode::invalid_argument, "subsystem '" + topology_.name(static_cast<int>(i)) +
                                                   "' has an own step of " + number_text(run_.own_steps_[i]) +
                                                   " s, which is nothing beside the end, " +
                                                   number_text(run_.t_stop_) + " s; allowed is more than " +
                                                   number_text(rounding()) + " s");
  for (std::size_t i = 0; i < n; ++i) check_span(static_cast<int>(i));
}

/// Own steps that the span or the rounding of its times does not go with.
void RunStart::check_span(int who) const {
  const double h = run_.own_step(who), span = run_.t_stop_ - run_.t_start_, most = rounding() / 6.0;
  const std::string named = "subsystem '" + topology_.name(who) + "' ",
                    step = sampled(who) ? "is sampled every " + number_text(h) + " s"
                                        : "has an own step of " + number_text(h) + " s";
  const Abilities& a = topology_.info(who).abilities;
  if (clocks_[static_cast<std::size_t>(who)].stop != Stop::finished &&
      run_.tolerance_.before(run_.t_stop_, run_.t_start_ + h) && !(a.chooses_step && a.lands)) {
    const std::string longer = named + step + ", longer than the span, " + number_text(span) + " s";
    if (!sampled(who) && !a.lands)
      throw Error(ErrorCode::invalid_argument,
                  longer + ", and can't shorten one: it would stand still; allowed is up to the span");
    run_.notes_.push_back(longer + (sampled(who) ? ": it acts at most once" : ": it takes one, shortened"));
  }
  if (!a.chooses_step && most > 1e-6 * h)
    run_.notes_.push_back(named + step + ", which times of the size of " +
                          number_text(std::max(std::abs(run_.t_start_), std::abs(run_.t_stop_)), 3) +
                          " s hold to " + number_text(most / h, 2) +
                          " of itself only; let the run begin near t = 0");
}

void RunStart::note_period(int who) {
  const double period = topology_.info(who).sampling.period,
               first = clocks_[static_cast<std::size_t>(who)].next_time;
  run_.own_steps_[static_cast<std::size_t>(who)] = period;
  if (!(first >= run_.t_start_))
    throw Error(ErrorCode::numerical, "subsystem '" + topology_.name(who) + "' gives " + number_text(first) +
                                          " s as its first instant; allowed is the start, " +
                                          number_text(run_.t_start_) + " s, or later");
  if (const double least = 4.0 * run_.tolerance_.width(run_.t_stop_, 0.0); !(period > least))
    throw Error(ErrorCode::invalid_argument,
                "subsystem '" + topology_.name(who) + "' is sampled every " + number_text(period) +
                    " s, which is nothing beside the end, " + number_text(run_.t_stop_) +
                    " s; allowed is more than " + number_text(least) + " s");
}

/// Who has finished at the start has no own step: the largest of the others stands in for it.
void RunStart::lend_steps() {
  double largest = 0.0;
  for (std::size_t i = 0; i < run_.own_steps_.size(); ++i)
    if (clocks_[i].stop != Stop::finished && !sampled(static_cast<int>(i)))
      largest = std::max(largest, run_.own_steps_[i]);
  for (std::size_t i = 0; i < run_.own_steps_.size(); ++i)
    if (clocks_[i].stop == Stop::finished && !sampled(static_cast<int>(i)))
      run_.own_steps_[i] = largest > 0.0 ? largest : run_.t_stop_ - run_.t_start_;
}

/// The own steps that fit into the longest step or lag: as many are taken in a call, and room is kept for
/// four times as many samples. Memory grows by itself where steps vary.
void RunStart::measure_batches() {
  constexpr double most = 1024.0;
  double longest = std::max(run_.coordination_.communication_step.value_or(0.0), times_.delay);
  for (const double h : run_.own_steps_) longest = std::max(longest, h);
  for (std::size_t i = 0; i < run_.seats_.size(); ++i)
    run_.seats_[i].batch = static_cast<std::int64_t>(std::min(longest / run_.own_steps_[i], most)) + 2;
}

std::vector<std::int64_t> RunStart::capacities(const std::vector<int>& seeds) const {
  std::vector<std::int64_t> rows;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    rows.push_back(std::max({History::min_capacity, 4 * run_.seats_[i].batch, std::int64_t{seeds[i]} + 3}));
  return rows;
}

/// An exchange that holds the first samples and, before them, as many seeds as asked for of each subsystem.
void RunStart::open_exchange(const std::vector<int>& seeds) {
  run_.exchange_.emplace(topology_, run_.t_start_, times_, capacities(seeds));
  for (int i = 0; i < topology_.size(); ++i) {
    History& history = run_.exchange_->history(i);
    history.watch(run_.t_start_ + (run_.t_stop_ - run_.t_start_) / 100.0, run_.coordination_.diverged_beyond);
    const auto& row = rows_[static_cast<std::size_t>(i)];
    std::copy(row.begin(), row.end(), history.room().append(run_.t_start_));
    if (const int count = seeds[static_cast<std::size_t>(i)]; count > 0) {
      history.commit(run_.t_start_, run_.tolerance_);
      past_.empty() ? history.seed(count, run_.own_step(i))
                    : history.seed(past_[static_cast<std::size_t>(i)]);
    }
    run_.exchange_->commit(i, run_.t_start_);
  }
}

}  // namespace tandem
