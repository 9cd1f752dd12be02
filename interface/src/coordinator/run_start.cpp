// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "run_start.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../number_text.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::not_supported, sentence); }

std::size_t position(const std::vector<int>& order, int who) {
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), who) - order.begin());
}

}  // namespace

RunStart::RunStart(Coordinator& run) : run_(run), topology_(run.topology_) {}

void RunStart::make() {
  first_samples();
  note_steps();
  std::vector<int> order = leaders_first();
  check_schemes(order);
  const double largest = *std::max_element(run_.own_steps_.begin(), run_.own_steps_.end());
  const double h = run_.coordination_.communication_step.value_or(largest);
  if (!std::isfinite(h) || h <= 0.0)
    throw Error(ErrorCode::invalid_argument,
                "communication_step is " + number_text(h) + " s; it must be finite and above 0");
  run_.schedule_.emplace(run_.coordination_.schedule, members(), std::move(order), reads(),
                         TimeSpan{run_.t_start_, run_.t_stop_}, h);
  for (std::size_t i = 0; i < clocks_.size(); ++i) run_.stand(static_cast<int>(i), clocks_[i]);
  lags_ = {run_.own_steps_, h};
  measure_batches();
  open_exchange(std::vector<int>(run_.own_steps_.size()));
  note_without_effect();
  run_.start_ = choose();
  if (run_.start_ == StartKind::derivatives) seed();
  if (run_.start_ == StartKind::repeat) repeat();
}

/// What the schedule has to know of them before they stand anywhere.
std::vector<Member> RunStart::members() const {
  std::vector<Member> all(static_cast<std::size_t>(topology_.size()));
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].lands = topology_.info(static_cast<int>(i)).abilities.lands;
  for (const Line& line : topology_.lines())
    if (line.how.kind == Reconstruction::Kind::mean)
      all[static_cast<std::size_t>(line.reader)].reads_mean = true;
  return all;
}

std::vector<Read> RunStart::reads() const {
  std::vector<Read> all;
  for (const Line& line : topology_.lines()) all.push_back({line.reader, line.source});
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
  if (!run_.coordination_.order.empty() && parallel)
    run_.notes_.push_back("order has no effect in schedule parallel");
}

/// Own steps as the subsystems stand.
void RunStart::note_steps() {
  const auto n = static_cast<std::size_t>(topology_.size());
  run_.own_steps_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int who = static_cast<int>(i);
    run_.own_steps_[i] = clocks_[i].next_time - clocks_[i].time;
    if (clocks_[i].stop != Stop::finished && !(run_.own_steps_[i] > 0.0 && std::isfinite(run_.own_steps_[i])))
      throw Error(ErrorCode::numerical,
                  "subsystem '" + topology_.name(who) + "' gives " + number_text(clocks_[i].next_time) +
                      " s as the end of its first own step, which is not later than the start");
  }
  lend_steps();
  for (std::size_t i = 0; i < n; ++i)
    if (!run_.tolerance_.before(run_.t_stop_ - run_.own_steps_[i], run_.t_stop_))
      throw Error(ErrorCode::invalid_argument,
                  "subsystem '" + topology_.name(static_cast<int>(i)) + "' has an own step of " +
                      number_text(run_.own_steps_[i]) + " s, which is nothing beside the end, " +
                      number_text(run_.t_stop_) + " s; allowed is more than " +
                      number_text(run_.tolerance_.width(run_.t_stop_, 0.0)) + " s");
}

/// Who has finished at the start has no own step: the largest of the others stands in for it.
void RunStart::lend_steps() {
  double largest = 0.0;
  for (std::size_t i = 0; i < run_.own_steps_.size(); ++i)
    if (clocks_[i].stop != Stop::finished) largest = std::max(largest, run_.own_steps_[i]);
  for (std::size_t i = 0; i < run_.own_steps_.size(); ++i)
    if (clocks_[i].stop == Stop::finished)
      run_.own_steps_[i] = largest > 0.0 ? largest : run_.t_stop_ - run_.t_start_;
}

void RunStart::check_named_order() const {
  const auto& named = run_.coordination_.order;
  const auto refuse_name = [](const std::string& name, const std::string& why) {
    throw Error(ErrorCode::invalid_argument,
                "coordination.order must name each subsystem once, slowest first; '" + name + "' " + why);
  };
  for (const std::string& name : named) {
    bool known = false;
    for (int i = 0; i < topology_.size(); ++i) known |= topology_.name(i) == name;
    if (!known) refuse_name(name, "is not a subsystem");
    if (std::count(named.begin(), named.end(), name) > 1) refuse_name(name, "stands there twice");
  }
  for (int i = 0; i < topology_.size(); ++i)
    if (std::find(named.begin(), named.end(), topology_.name(i)) == named.end())
      refuse_name(topology_.name(i), "is missing");
}

std::vector<int> RunStart::leaders_first() const {
  std::vector<int> order(run_.own_steps_.size());
  std::iota(order.begin(), order.end(), 0);
  const bool ascending = run_.coordination_.schedule == Schedule::Kind::fastest_first;
  const auto& named = run_.coordination_.order;
  if (named.empty()) {
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      const double ha = run_.own_step(a), hb = run_.own_step(b);
      return ascending ? ha < hb : ha > hb;
    });
    return order;
  }
  check_named_order();
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::find(named.begin(), named.end(), topology_.name(a)) <
           std::find(named.begin(), named.end(), topology_.name(b));
  });
  if (ascending) std::reverse(order.begin(), order.end());
  return order;
}

void RunStart::check_schemes(const std::vector<int>& order) const {
  if (run_.coordination_.schedule == Schedule::Kind::staggered && order.size() != 2)
    refuse("schedule staggered couples two subsystems; there are " + std::to_string(order.size()));
  if (run_.coordination_.schedule == Schedule::Kind::staggered && misses_middle(order[1], order[0]))
    run_.notes_.push_back(
        "subsystem '" + topology_.name(order[1]) +
        "' can't shorten a step, so schedule staggered keeps a first order part of the size of its own "
        "step over that of '" +
        topology_.name(order[0]) + "'");
  for (const Line& line : topology_.lines()) check_line(line, order);
}

/// The fast side can't cut a step, and none of its nodes lies in the middle of the slow side's step.
bool RunStart::misses_middle(int fast, int slow) const {
  const double middle = run_.own_step(slow) / 2.0, nearest = std::remainder(middle, run_.own_step(fast));
  const Abilities &a = topology_.info(fast).abilities, &b = topology_.info(slow).abilities;
  return !a.lands &&
         (a.chooses_step || b.chooses_step || std::abs(nearest) > run_.tolerance_.width(middle, 0.0));
}

void RunStart::check_line(const Line& line, const std::vector<int>& order) const {
  using Kind = Reconstruction::Kind;
  const Schedule::Kind schedule = run_.coordination_.schedule;
  const std::string what =
      "input " + topology_.input_name(line.reader, line.input) + " is reconstructed by " + line.how.name();
  const bool turns = schedule == Schedule::Kind::slowest_first || schedule == Schedule::Kind::fastest_first;
  if (schedule == Schedule::Kind::staggered && line.how.kind != Kind::matched_hold)
    refuse(what + "; schedule staggered takes matched_hold only");
  if (schedule == Schedule::Kind::parallel && line.how.kind == Kind::matched_hold)
    refuse(what + ", which needs subsystems that take turns; schedule parallel has none");
  if (line.how.kind == Kind::mean && !(turns && position(order, line.source) < position(order, line.reader)))
    refuse(what + ", which needs a source that is ahead of its reader; in schedule " +
           std::string(Schedule::name(schedule)) + " '" + topology_.name(line.source) +
           "' is not ahead of '" + topology_.name(line.reader) + "'");
  if (line.lag == Lag::memory && topology_.info(line.reader).abilities.chooses_step)
    refuse("input " + topology_.input_name(line.reader, line.input) +
           " has a memory of one own step, but its subsystem chooses its steps; use a delay");
}

/// The own steps that fit into the longest step or lag: as many are taken in a call, and room is kept for
/// four times as many samples. Memory grows by itself where steps vary.
void RunStart::measure_batches() {
  constexpr double most = 1024.0;
  double longest = std::max(run_.coordination_.communication_step.value_or(0.0), lags_.delay);
  for (const double h : run_.own_steps_) longest = std::max(longest, h);
  for (std::size_t i = 0; i < run_.seats_.size(); ++i)
    run_.seats_[i].batch = static_cast<std::int64_t>(std::min(longest / run_.own_steps_[i], most)) + 2;
}

std::vector<std::int64_t> RunStart::capacities() const {
  std::vector<std::int64_t> rows;
  for (const auto& seat : run_.seats_) rows.push_back(std::max(History::min_capacity, 4 * seat.batch));
  return rows;
}

/// An exchange that holds the first samples and, before them, as many seeds as asked for of each subsystem.
void RunStart::open_exchange(const std::vector<int>& seeds) {
  run_.exchange_.emplace(topology_, run_.tolerance_, lags_, capacities());
  for (int i = 0; i < topology_.size(); ++i) {
    History& history = run_.exchange_->history(i);
    const auto& row = rows_[static_cast<std::size_t>(i)];
    std::copy(row.begin(), row.end(), history.room().append(run_.t_start_));
    if (const int count = seeds[static_cast<std::size_t>(i)]; count > 0) {
      history.commit(run_.t_start_, run_.tolerance_);
      history.seed(count, run_.own_step(i));
    }
    run_.exchange_->commit(i, run_.t_start_);
  }
}

}  // namespace tandem
