// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "courses.hpp"

#include <algorithm>

namespace tandem::engine {
namespace {

using Code = Operation::Code;
using Kind = Slot::Kind;

/// Marks what an output needs at an instant. After the events a held value is what they have given it; before
/// them it is known, but for modes, which the inputs of the instant have turned first.
class Instant {
 public:
  explicit Instant(const Lowering& d) : d_(d), maker_(makers(d)) {
    for (auto* marked : {&before_, &after_}) marked->resize(d.signals.size());
  }

  void mark_after(int signal) { mark(signal, after_, true); }
  std::vector<bool> all() const {
    std::vector<bool> either = before_;
    for (std::size_t s = 0; s < either.size(); ++s) either[s] = either[s] || after_[s];
    return either;
  }

 private:
  void mark(int signal, std::vector<bool>& marked, bool after) {
    const int slot = d_.resolved(signal);
    if (marked[slot]) return;
    marked[slot] = true;
    if (maker_[slot] >= 0)
      for (const int from : needed_by(d_, d_.steps[maker_[slot]])) mark(from, marked, after);
    for (const Event& event : d_.events)
      for (const Update& u : event.updates)
        if (d_.resolved(u.to) == slot) mark(event, u, marked, after);
  }

  void mark(const Event& event, const Update& u, std::vector<bool>& marked, bool after) {
    if (event.effect == Event::Effect::mode) return mark(u.from, marked, after);
    if (!after) return;
    if (event.kind == Event::Kind::periodic) return mark(u.from, before_, false);
    for (const int from : {u.from, event.signal}) mark(from, after_, true);
  }

  const Lowering& d_;
  std::vector<int> maker_;
  std::vector<bool> before_, after_;
};

}  // namespace

Courses::Courses(const Lowering& d, const std::vector<Sequence>& order)
    : d_(d), order_(order), held_(d.signals.size(), true), jumps_(d.signals.size()) {
  for (std::size_t s = 0; s < d.signals.size(); ++s) {
    const Kind kind = d.signals[s].kind;
    held_[s] = kind == Kind::held || kind == Kind::constant || kind == Kind::result;
  }
  for (const Event& event : d.events)
    for (const Update& u : event.updates)
      if (event.kind == Event::Kind::own_step)
        held_[slot(u.to)] = false;
      else if (event.effect != Event::Effect::limit)
        jumps_[slot(u.to)] = true;
  for (const DataJumps& data : d.data_jumps) jumps_[slot(data.run)] = true;
  spread(held_, [this](const Step& step) { return is_held(step); });
  spread(jumps_, [this](const Step& step) { return can_jump(step); });
}

/// In the order of evaluation, and again where that goes in circles.
template <class Of>
void Courses::spread(std::vector<bool>& to, const Of& of) {
  for (bool more = true; more;) {
    more = false;
    for (const Sequence& sequence : order_)
      for (const int k : sequence.steps) {
        const Step& step = d_.steps[k];
        const bool now = of(step);
        more = more || now != to[slot(step.out)];
        for (int i = 0; i < step.count; ++i) to[slot(step.out + i)] = now;
      }
  }
}

bool Courses::is_held(const Step& step) const {
  const auto needed = needed_by(d_, step);
  return std::all_of(needed.begin(), needed.end(), [this](int from) { return held(from); });
}

/// Where the mode of a limit changes, both sides are the same.
bool Courses::can_jump(const Step& step) const {
  const Operation& o = step.operations.front();
  if (o.code == Code::clamp || o.code == Code::dead_zone) return jumps(o.a);
  if (o.code == Code::delay) {
    const int from = d_.delays[o.b].from;
    return jumps(from) || follows_input(from);
  }
  const auto needed = needed_by(d_, step);
  return std::any_of(needed.begin(), needed.end(), [this](int from) { return jumps(from); });
}

bool Courses::follows_input(int signal) const {
  const auto needed = needed_at_once(d_, {signal});
  for (std::size_t s = 0; s < needed.size(); ++s)
    if (needed[s] && d_.signals[s].kind == Kind::input) return true;
  return false;
}

bool Courses::sampled(const std::vector<int>& outputs, const std::vector<bool>& alive) const {
  std::vector<bool> free(d_.signals.size());  // changes between instants
  bool is_periodic = false;
  for (std::size_t s = 0; s < d_.signals.size(); ++s)
    if (alive[s] && (d_.signals[s].kind == Kind::state || d_.signals[s].kind == Kind::past)) return false;
  for (const Event& event : d_.events)
    for (const Update& u : event.updates) {
      if (!alive[slot(u.to)]) continue;
      const bool is_free = event.kind == Event::Kind::crossing && !held(event.signal);
      if (event.kind == Event::Kind::own_step || (is_free && event.effect != Event::Effect::mode))
        return false;
      is_periodic = is_periodic || event.kind == Event::Kind::periodic;
      free[slot(u.to)] = free[slot(u.to)] || is_free;
    }
  for (const DataJumps& data : d_.data_jumps) free[slot(data.run)] = alive[slot(data.run)];
  const auto seen = needed_at_once(d_, outputs);
  for (std::size_t s = 0; s < seen.size(); ++s)
    if (seen[s] && (free[s] || !held_[slot(static_cast<int>(s))])) return false;
  return is_periodic;
}

std::vector<bool> needed_at_instant(const Lowering& diagram, int output) {
  Instant instant(diagram);
  instant.mark_after(output);
  return instant.all();
}

}  // namespace tandem::engine
