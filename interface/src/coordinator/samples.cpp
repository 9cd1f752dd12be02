// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What sampled subsystems do at their instants.
#include <algorithm>
#include <cmath>

#include "../number_text.hpp"
#include "named.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/error.hpp"

namespace tandem {

/// In parallel the others go on to the same communication point when some have acted, or those with events
/// have gone, on inputs of which all but the held ones are as they were when the round began.
void Coordinator::make_in_parts(std::span<const Turn> turns) {
  for (; !turns.empty() && !stopped_; turns = schedule_->rest_of_round()) make_part(turns);
  if (schedule_->kind() == Schedule::Kind::parallel)
    for (int i = 0; i < topology_.size(); ++i) exchange_->publish(i);
}

void Coordinator::make_part(std::span<const Turn> turns) {
  acting_.clear();
  going_.clear();
  for (const Turn& turn : turns)
    if (schedule_->member(turn.who).sampled)
      acting_.push_back(turn.who);
    else
      going_.push_back(turn);
  if (frozen_) let_one_switch();
  act();
  if (!going_.empty()) make(going_);
}

/// Two that switch each other, and do so at the same time, on what was known before, would go on for ever. Of
/// those that have had events again and again where they stand one goes on, by their order, and the others
/// see what it gives first.
void Coordinator::let_one_switch() {
  const auto switches = [this](const Turn& turn) { return seat(turn.who).idle_calls > 1; };
  if (std::count_if(going_.begin(), going_.end(), switches) < 2) return;
  const auto goes = [&](int who) {
    return std::any_of(going_.begin(), going_.end(),
                       [&](const Turn& turn) { return turn.who == who && switches(turn); });
  };
  const auto order = schedule_->order();
  const int first = *std::find_if(order.begin(), order.end(), goes);
  std::erase_if(going_, [&](const Turn& turn) { return switches(turn) && turn.who != first; });
}

/// Those that read each other first give all their outputs, then go on on these.
void Coordinator::act() {
  const auto together = [this](int who) { return together_[static_cast<std::size_t>(who)] != 0; };
  for (const int who : acting_) acts_[static_cast<std::size_t>(who)] = together(who);
  for (const int who : output_calls_)
    if (acts_[static_cast<std::size_t>(who)] != 0) {
      sample(who, SamplePart::outputs);
      give(who);
    }
  for (const int who : acting_) {
    const Clock clock = sample(who, together(who) ? SamplePart::states : SamplePart::both);
    if (!together(who)) give(who);
    acts_[static_cast<std::size_t>(who)] = 0;
    go_on(who, clock);
  }
}

Clock Coordinator::sample(int who, SamplePart part) {
  Seat& seat = this->seat(who);
  const auto u = exchange_->sample(who, {seat.time, own_next(who)});
  if (observer_) observer_->inputs_at(who, own_next(who), exchange_->values(who));
  const auto outputs = static_cast<std::size_t>(topology_.info(who).output_size());
  seat.effort.exchanges += 1;
  return named(topology_.name(who), [&] {
    return seat.subsystem->sample(own_next(who), part, u, {outputs_.data(), outputs});
  });
}

/// Its outputs, as a row: a second time at one instant in place of the first.
void Coordinator::give(int who) {
  History& history = exchange_->history(who);
  const double t = own_next(who) + topology_.info(who).sampling.latency,
               newest = history.time(history.newest());
  const bool again = acts_[static_cast<std::size_t>(who)] > 1;
  const std::span<const double> y(outputs_.data(), static_cast<std::size_t>(history.outputs()));
  if (const auto bad = std::find_if(y.begin(), y.end(), [](double v) { return !std::isfinite(v); });
      bad != y.end())
    refuse_sample(who,
                  "it gave " + topology_.output_name(who, static_cast<int>(bad - y.begin())) + " not finite");
  if (!again && !history.has_room(1)) exchange_->make_room(who, 1);
  double* const to = again ? history.newest_values() : history.room().append(t, t == newest);
  std::copy(y.begin(), y.end(), to);
  if (again) {
    history.check_newest();
    return exchange_->remake_newest(who);
  }
  exchange_->commit(who, t);
  if (acts_[static_cast<std::size_t>(who)] != 0) acts_[static_cast<std::size_t>(who)] = 2;
}

/// To its next instant, which those wait for that it is related to.
void Coordinator::go_on(int who, const Clock& clock) {
  Seat& seat = this->seat(who);
  if (clock.time != own_next(who))
    refuse_sample(who, "it says that it stands at t = " + number_text(clock.time) + " s");
  const double earliest = own_next(who) + topology_.info(who).sampling.period;
  if (clock.stop != Stop::finished &&
      !(clock.next_time > own_next(who) && !tolerance_.before(clock.next_time, earliest)))
    refuse_sample(who, "it gives " + number_text(clock.next_time) + " s as its next instant; allowed is " +
                           number_text(earliest) + " s, a period later, or more");
  seat.effort.steps += 1;
  stand(who, clock);
  place_neighbours(who);
  tell(who);
}

void Coordinator::refuse_sample(int who, const std::string& what) const {
  throw Error(ErrorCode::numerical, "subsystem '" + topology_.name(who) +
                                        "', sample at t = " + number_text(own_next(who)) + " s: " + what);
}

void Coordinator::place_neighbours(int sampled) {
  schedule_->each_neighbour(sampled, [this](int who) {
    if (!schedule_->member(who).sampled) place(who);
  });
}

void Coordinator::place(int who) {
  const double time = seats_[static_cast<std::size_t>(who)].time,
               next = own_next_[static_cast<std::size_t>(who)];
  if (!exchange_) return schedule_->stand(who, time, next);
  const bool jumped = schedule_->member(who).jumps && exchange_->jumps_unread(who, time);
  schedule_->stand(who, time, next, exchange_->next_break(who, time), jumped);
}

/// Sampled ones first, as others land at their instants.
void Coordinator::place_all() {
  for (const bool sampled : {true, false})
    for (int i = 0; i < topology_.size(); ++i)
      if (schedule_->member(i).sampled == sampled) place(i);
}

}  // namespace tandem
