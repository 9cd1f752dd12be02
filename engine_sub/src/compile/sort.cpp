// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sort.hpp"

#include <algorithm>

namespace tandem::engine {
namespace {

using Code = Operation::Code;

/// Marks what a slot needs at once.
class Needs {
 public:
  explicit Needs(const Lowering& d) : d_(d), maker_(makers(d)), marked_(d.signals.size()) {}

  void mark(int slot) {
    slot = d_.resolved(slot);
    if (marked_[slot]) return;
    marked_[slot] = true;
    for (int i = 0; i < d_.signals[slot].count; ++i) mark(d_.signals[slot].first + i);
    if (maker_[slot] < 0) return;
    for (const Operation& o : d_.steps[maker_[slot]].operations)
      for (const int from : reads(o)) mark(from);
  }
  const std::vector<bool>& marked() const { return marked_; }

 private:
  const Lowering& d_;
  std::vector<int> maker_;
  std::vector<bool> marked_;
};

}  // namespace

std::vector<int> makers(const Lowering& d) {
  std::vector<int> of(d.signals.size(), -1);
  for (std::size_t k = 0; k < d.steps.size(); ++k)
    for (int i = 0; i < d.steps[k].count; ++i) of[d.steps[k].out + i] = static_cast<int>(k);
  return of;
}

std::vector<int> reads(Operation o) {
  std::vector<int> slots;
  for (const int* slot : slots_of(o)) slots.push_back(*slot);
  return slots;
}

std::vector<int> needed_by(const Lowering& d, const Step& step) {
  std::vector<int> slots;
  for (const Operation& o : step.operations)
    for (const int from : reads(o)) {
      const int slot = d.resolved(from);
      slots.push_back(slot);
      for (int i = 0; i < d.signals[slot].count; ++i) slots.push_back(d.resolved(d.signals[slot].first + i));
    }
  return slots;
}

std::vector<int*> slots_of(Operation& o) {
  switch (o.code) {
    case Code::linear:
    case Code::polynomial:
    case Code::function:
    case Code::curve:
    case Code::beyond:
    case Code::add:
      return {&o.a};
    case Code::clamp:
    case Code::leave:
    case Code::dead_zone:
    case Code::delay:
    case Code::data:
      return {&o.a, &o.more};
    case Code::call: {
      std::vector<int*> slots;
      for (int* const slot : {&o.a, &o.b})
        if (*slot >= 0) slots.push_back(slot);
      return slots;
    }
    case Code::select:
      return {&o.a, &o.b, &o.more};
    default:
      return {&o.a, &o.b};
  }
}

std::vector<bool> needed_at_once(const Lowering& d, const std::vector<int>& slots) {
  Needs needs(d);
  for (const int slot : slots) needs.mark(slot);
  return needs.marked();
}

std::vector<bool> alive(const Lowering& d, const std::vector<int>& outputs) {
  Needs needs(d);
  for (const int slot : outputs) needs.mark(slot);
  for (const Event& event : d.events)
    if (event.bound >= 0) needs.mark(event.signal), needs.mark(event.sign);
  for (std::size_t before = 0, now = 1; before != now;) {
    before = now;
    for (std::size_t s = 0; s < d.signals.size(); ++s)
      if (needs.marked()[s] && d.signals[s].kind == Slot::Kind::state) needs.mark(d.signals[s].rate);
    for (const Event& event : d.events)
      for (const Update& u : event.updates)
        if (needs.marked()[d.resolved(u.to)]) {
          needs.mark(u.from);
          if (event.sign >= 0) needs.mark(event.sign);
          if (event.signal >= 0) needs.mark(event.signal);
        }
    for (const Delay& delay : d.delays)
      if (needs.marked()[delay.past]) needs.mark(delay.from);
    for (const auto* updates : {&d.settled, &d.starts})
      for (const Update& u : *updates)
        if (needs.marked()[d.resolved(u.to)]) needs.mark(u.from);
    now = static_cast<std::size_t>(std::count(needs.marked().begin(), needs.marked().end(), true));
  }
  return needs.marked();
}

}  // namespace tandem::engine
