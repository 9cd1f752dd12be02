// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "past.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {
namespace {

constexpr int most_settlings = 100;
constexpr int smooth = 0, broken = 1, kink = 2;  // levels of Past::record

}  // namespace

Simulation::Simulation(const Program& program, InputSource* inputs, std::unique_ptr<Integrator> integrator,
                       const SimulationSettings& settings)
    : system_(program, inputs), integrator_(std::move(integrator)), settings_(settings) {
  integrator_->check_fit(program.state_names);
  for (const Delay& delay : program.delays)
    if (delay.past >= 0) delays_.push_back(&delay);
  follows_courses_ = inputs && integrator_->chooses_steps();
  was_told_.resize(program.bounds.size());
  has_turns_ = std::any_of(program.crossings.begin(), program.crossings.end(),
                           [](const Crossing& c) { return c.turn >= 0; });
  has_instants_ = has_turns_ || !program.breaks.empty() || !program.periodics.empty() || !delays_.empty() ||
                  !program.data_jumps.empty();
  watch_jumps();
}

void Simulation::start(double t, bool with_events) {
  system_.image() = system_.program().image;
  system_.react(nullptr);
  start_ = time_ = t;
  begun_ = false;
  for (const Delay* d : delays_) past(*d).clear();
  pass_data_jumps();
  settle();
  for (const Crossing& c : system_.program().crossings) system_.image()[c.sign] = sign_at_start(c);
  for (const Periodic& p : system_.program().periodics)
    system_.image()[p.count] = std::max(0.0, std::ceil(-p.offset / p.period));
  record(broken);
  if (with_events) fire_known();
  if (system_.changed() >= 0) fire_crossings();
  refuse_outside();
  if (watches_jumps_) note_sizes();
  integrator_->restart(system_, t, Restart::state);
}

/// A signal that begins at zero is on the side from which its event sees it leave.
double Simulation::sign_at_start(const Crossing& c) const {
  const double x = system_.image()[c.signal];
  if (c.sees_start) return -1.0;
  return x > 0.0 || (x == 0.0 && c.direction == Crossing::Direction::falling) ? 1.0 : -1.0;
}

/// All signals before an event.
void Simulation::remember() {
  system_.evaluate_updates();
  before_ = system_.image();
}

/// Values at the start that come from signals, and modes as the signals want them.
void Simulation::settle() {
  const Program& program = system_.program();
  for (int round = 0; round < most_settlings; ++round) {
    system_.evaluate(time_);
    remember();
    apply(program.starts);
    apply(program.settled);
    if (before_ == system_.image()) return;
  }
  refuse_not_finite();
  const auto changes = std::mismatch(before_.begin(), before_.end(), system_.image().begin()).first;
  const auto slot = static_cast<std::size_t>(changes - before_.begin());
  throw Error(ErrorCode::numerical,
              fmt::format("switches, limits and initial values don't settle at the start, t = {} s, in {} "
                          "rounds: {} changes from each to the next",
                          time_, most_settlings, program.named(program.signal_blocks[slot])));
}

double Simulation::step(double t_end) {
  begin_step();
  return advance(t_end);
}

void Simulation::run(double t_end) {
  begin_step();
  while (time_ < t_end) advance(t_end);
}

/// What happens at the beginning of each own step, from the signals at the end of the last.
void Simulation::begin_step() {
  const auto& updates = system_.program().step_updates;
  slot(system_.program().events) = 0.0;
  if (updates.empty()) return;
  remember();
  apply(updates);
  system_.evaluate(time_);
  if (system_.changed() >= 0) fire_crossings();
  const auto& image = system_.image();
  const auto differs = [&](const Update& u) { return image[u.to] != before_[u.to]; };
  if (std::none_of(updates.begin(), updates.end(), differs)) return;
  record(broken);
  integrator_->restart(system_, time_, Restart::event);
}

double Simulation::advance(double t_end) {
  if (!std::exchange(begun_, true)) look_at_bounds();
  call_begin_ = time_;
  if (!delays_.empty()) note_jumps();
  course_end_ = time_;
  double& longest = slot(system_.program().longest_step);
  longest = std::max(longest, t_end - time_);
  jumped_ = false;
  while (time_ < t_end && !(stops_ && jumped_)) {
    if (follows_courses_ && time_ >= course_end_) begin_course();
    const double instant = has_instants_ || follows_courses_ ? next_instant(t_end) : t_end;
    const double before = time_, events = slot(system_.program().events);
    time_ = integrator_->advance(system_, time_, instant);
    refuse_not_finite();
    if (!system_.program().ranges.empty()) refuse_outside();
    const bool arrived = time_ >= instant;
    if (!delays_.empty()) record(bends() ? kink : smooth);
    const bool watches = watches_jumps_ && (system_.changed() >= 0 || (arrived && has_instants_));
    if (watches_jumps_) note_sizes();
    if (watches) note_left();
    if (system_.changed() >= 0) fire_crossings();
    if (arrived && has_instants_) fire_known(), turn_delays();
    if (has_turns_) look_at_turns();
    if (watches) jumped_ = has_jumped(cause());
    if (!arrived && slot(system_.program().events) == events && time_ > before) return time_;
  }
  return time_;
}

double Simulation::rounding() const { return 8.0 * std::numeric_limits<double>::epsilon() * std::abs(time_); }

/// Where a source has a kink now, within the rounding of time.
bool Simulation::bends() const {
  const auto& breaks = system_.program().breaks;
  const auto at = std::lower_bound(breaks.begin(), breaks.end(), time_ - rounding());
  return at != breaks.end() && *at <= time_ + rounding();
}

/// Where a source has a kink or an event is due, if that is before t_end by more than the rounding of time.
double Simulation::next_instant(double t_end) {
  const Program& program = system_.program();
  double next = t_end;
  const auto earlier = [&](double t) {
    if (t < t_end - rounding()) next = std::min(next, t);
  };
  const auto bend = std::upper_bound(program.breaks.begin(), program.breaks.end(), time_ + rounding());
  if (bend != program.breaks.end()) earlier(*bend);
  if (follows_courses_) earlier(course_end_);
  if (has_turns_) earlier(next_turn());
  for (const Periodic& p : program.periodics) earlier(due(p));
  for (const DataJumps& d : program.data_jumps) earlier(next_jump(d));
  for (const Delay* d : delays_)
    for (const double due : {past(*d).due(), time_ + d->time}) earlier(due);
  return next;
}

double Simulation::next_event() { return next_instant(std::numeric_limits<double>::infinity()); }

/// Multiplied from the first one on.
double Simulation::due(const Periodic& p) const {
  return (start_ + p.offset) + system_.image()[p.count] * p.period;
}

Past Simulation::past(const Delay& delay) { return {delay, system_.image().data() + delay.past}; }

/// Inputs take another course from here on; where one jumps with that, the integrator begins anew.
void Simulation::begin_course() {
  const auto first = system_.image().begin() + system_.program().time + 1;
  const auto count = static_cast<std::ptrdiff_t>(system_.program().inputs.size());
  before_.assign(first, first + count);
  course_end_ = system_.begin_course(time_);
  system_.evaluate(time_);
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
  };
  if (!std::equal(before_.begin(), before_.end(), first, same))
    integrator_->restart(system_, time_, Restart::event);
}

/// What delays remember of this time, and whether they still have what they give.
void Simulation::record(int level) {
  for (const Delay* d : delays_) {
    if (level == kink) past(*d).record(time_, system_.image()[d->from], smooth);
    past(*d).record(time_, system_.image()[d->from], level);
    if (!past(*d).reaches(time_ - d->time))
      throw Error(ErrorCode::numerical,
                  fmt::format("{} remembers {} points, which reach back less than its delay of {} s at "
                              "t = {} s; allowed is more of them at its key points",
                              system_.program().named(d->name), d->points, d->time, time_));
  }
}

/// Signals that have jumped with the inputs since they were recorded.
void Simulation::note_jumps() {
  system_.evaluate_again(time_);
  for (const Delay* d : delays_) {
    const double now = system_.image()[d->from], before = past(*d).newest();
    if (std::abs(now - before) > 1e-12 * std::max(std::abs(now), std::abs(before)))
      past(*d).record(time_, now, broken);
  }
}

/// Where what a delay gives jumps or bends, it is another run that it gives from there on.
void Simulation::turn_delays() {
  int level = 0;
  for (const Delay* d : delays_)
    if (past(*d).due() <= time_ + rounding()) level = std::max(level, past(*d).turn() + 1);
  if (level == 0) return;
  system_.evaluate(time_);
  if (level <= most_levels) record(level);
  if (system_.changed() >= 0) fire_crossings();
  integrator_->restart(system_, time_, Restart::event);
}

/// What is known beforehand: data jump, and events of periods see what follows from that.
void Simulation::fire_known() {
  if (pass_data_jumps()) {
    system_.evaluate(time_);
    fire_crossings();
  }
  bool fired = false;
  for (const Periodic& p : system_.program().periodics) {
    double& count = system_.image()[p.count];
    if (due(p) > time_ + rounding()) continue;
    if (!std::exchange(fired, true)) remember();
    count += 1.0;
    apply(p.updates);
    happened(p.name);
  }
  if (!fired) return;
  system_.evaluate(time_);
  fire_crossings();
}

/// Until no sign changes any more. The values before are those of the first event of an instant for all that
/// are due with it.
void Simulation::fire_crossings() {
  while (system_.changed() >= 0) {
    happened(system_.program().crossings[static_cast<std::size_t>(system_.changed())].name);
    remember();
    for (int k = system_.changed(); k >= 0; k = system_.changed(k + 1)) {
      const Crossing& c = system_.program().crossings[static_cast<std::size_t>(k)];
      const bool rises = before_[c.signal] > 0.0;
      system_.image()[c.sign] = rises && !c.repeats ? 1.0 : -1.0;
      using enum Crossing::Direction;
      if (c.direction != both && (c.direction == rising) != rises) continue;
      apply(c.updates);
      if (c.turn >= 0) slot(c.turn) = time_;
      if (c.bound >= 0) leave(c);
    }
    system_.evaluate(time_);
  }
  record(broken);
  integrator_->restart(system_, time_, Restart::event);
}

void Simulation::apply(const std::vector<Update>& updates) {
  for (const Update& u : updates) system_.image()[u.to] = before_[u.from];
}

void Simulation::happened(const std::string& block) {
  if (++slot(system_.program().events) <= settings_.most_events) return;
  throw Error(ErrorCode::numerical,
              fmt::format("{} chatters at t = {} s: more than {} events in one step",
                          system_.program().named(block), time_, settings_.most_events));
}

}  // namespace tandem::engine
