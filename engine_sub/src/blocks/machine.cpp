// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "kinds.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;
using Direction = Crossing::Direction;

constexpr double never = 1e300;  // [s]

/// A machine while it is lowered: held values that its transitions share.
class Machine {
 public:
  Machine(Lowering& to, Arguments& a)
      : to_(to), a_(a), names_(a.texts("states")), start_(a.has("start") ? state(a, "start") : 0) {
    for (std::size_t k = 0; k < names_.size(); ++k) is_.push_back(to.held(k == start_ ? 1.0 : 0.0));
    free_ = to.held(1.0);
    entered_ = to.held();
    to.start(entered_, a.has("entered") ? to.constant(a.number("entered")) : to.time());
    unlocked_ = to.held(never);
    lock_ = a.number("lockout");
    if (lock_ < 0.0) a.refuse("lockout", fmt::format("{}", lock_), "0 or more [s]");
    if (a.has("gears")) gears_ = a.text("gears");
  }

  void lower() {
    outputs();
    auto transitions = a_.tables("transitions");
    if (transitions.empty()) a_.refuse("transitions", "not there", "an array of tables, one for each");
    // Of two at once the first in the file has the last word.
    std::reverse(transitions.begin(), transitions.end());
    for (const Block& block : transitions) {
      Arguments part = a_.part("transitions[]", block);
      transition(part);
      part.refuse_unknown();
    }
    keep_apart();
    if (!gears_.empty()) keep_in_order();
    if (lock_ > 0.0) to_.update(rises(to_.difference(to_.time(), unlocked_)), free_, to_.constant(1.0));
  }

 private:
  struct Output {
    int now, before;
    std::vector<int> of;  ///< by state
  };

  /// Of a transition, what others have to agree with.
  struct Way {
    std::size_t from, next;
    int input, threshold;
    bool above;
    std::string where;
  };

  void outputs() {
    bool is_there = false;
    std::vector<double> numbers;
    for (std::size_t k = 0; k < names_.size(); ++k) numbers.push_back(static_cast<double>(k + 1));
    to_.define("", output(numbers).now);
    to_.define("entered", entered_);
    for (const Block& block : a_.tables("outputs"))
      for (const auto& [name, value] : block.values) {
        Arguments part = a_.part("outputs", block);
        const auto values = part.numbers(name);
        if (values.size() != names_.size())
          part.refuse(name, fmt::format("an array of {}", values.size()),
                      fmt::format("one of {}, a number for each state", names_.size()));
        if (name == gears_) refuse_disorder(part, values);
        const Output& made = output(values);
        to_.define(name, made.now);
        to_.define(name + "_before", made.before);
        is_there = is_there || name == gears_;
      }
    if (!gears_.empty() && !is_there)
      a_.refuse("gears", "'" + gears_ + "'", "the name of one of the outputs");
  }

  /// Ratios fall from gear to gear and stay above 0.
  void refuse_disorder(Arguments& part, const std::vector<double>& ratios) {
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      const bool falls = k == 0 || ratios[k] < ratios[k - 1];
      if (ratios[k] > 0.0 && falls) continue;
      const std::string most =
          k == 0 ? "" : fmt::format(" and below {}, that of '{}'", ratios[k - 1], names_[k - 1]);
      part.refuse(gears_, fmt::format("{} in '{}'", ratios[k], names_[k]), "a number above 0" + most);
    }
  }

  const Output& output(const std::vector<double>& values) {
    Output made{to_.held(values[start_]), to_.held(values[start_]), {}};
    for (const double value : values) made.of.push_back(to_.constant(value));
    return outputs_.emplace_back(std::move(made));
  }

  /// Where a signal rises above 0, or is above it at the start.
  int rises(int signal) {
    const int event = to_.crossing(signal, Direction::rising);
    to_.events[event].sees_start = true;
    return event;
  }

  void transition(Arguments& t) {
    const std::size_t from = state(t, "from"), next = state(t, "to");
    const double dwell = t.number("dwell");
    if (dwell < 0.0) t.refuse("dwell", fmt::format("{}", dwell), "0 or more [s]");
    const int enabled = to_.operation(Code::product, is_[from], free_);
    const int armed = to_.operation(Code::select, condition(t), to_.constant(-1.0), {}, enabled);
    const bool above = t.has("above");
    ways_.push_back({from, next, t.wire("input"), t.wire(above ? "above" : "below"), above, t.where()});
    if (dwell == 0.0) return take(rises(armed), next);
    const int due = to_.held(never);
    to_.update(rises(armed), due, to_.linear(dwell, 1.0, to_.time()));
    to_.update(to_.crossing(armed, Direction::falling), due, to_.constant(never));
    take(rises(to_.difference(to_.time(), due)), next);
  }

  /// A way up and the way back down on the same input: with thresholds in the wrong order it would go to and
  /// fro.
  void keep_apart() {
    for (const Way& up : ways_)
      for (const Way& down : ways_)
        if (up.above && !down.above && up.from == down.next && up.next == down.from && up.input == down.input)
          keep_above(up, down);
  }

  /// Of gears: a change from or to a later one needs a higher threshold, up and down alike.
  void keep_in_order() {
    for (const Way& later : ways_)
      for (const Way& earlier : ways_)
        if (later.above == earlier.above && later.input == earlier.input && later.from > earlier.from &&
            later.next > earlier.next && (later.next > later.from) == (earlier.next > earlier.from))
          keep_above(later, earlier);
  }

  void keep_above(const Way& high, const Way& low) {
    to_.orders.push_back(
        {high.threshold, low.threshold, high.where, a_.owner(), threshold(high), threshold(low)});
  }

  std::string threshold(const Way& way) const {
    return fmt::format("the threshold from '{}' to '{}'", names_[way.from], names_[way.next]);
  }

  std::size_t state(Arguments& t, const std::string& key) {
    const std::string name = t.text(key);
    const auto it = std::find(names_.begin(), names_.end(), name);
    if (it == names_.end())
      t.refuse(key, "'" + name + "'", "one of the states " + fmt::format("{}", fmt::join(names_, ", ")));
    return static_cast<std::size_t>(it - names_.begin());
  }

  /// A signal that is above 0 where the transition may begin.
  int condition(Arguments& t) {
    const int input = t.wire("input");
    if (t.has("above") == t.has("below"))
      t.refuse("input", "given with both or none of above and below", "one of them, a threshold");
    return t.has("above") ? to_.difference(input, t.wire("above")) : to_.difference(t.wire("below"), input);
  }

  void take(int event, std::size_t next) {
    for (std::size_t k = 0; k < is_.size(); ++k)
      to_.update(event, is_[k], to_.constant(k == next ? 1.0 : 0.0));
    for (const Output& output : outputs_) {
      to_.update(event, output.before, output.now);
      to_.update(event, output.now, output.of[next]);
    }
    to_.update(event, entered_, to_.time());
    if (lock_ == 0.0) return;
    to_.update(event, free_, to_.constant(0.0));
    to_.update(event, unlocked_, to_.linear(lock_, 1.0, to_.time()));
  }

  Lowering& to_;
  Arguments& a_;
  std::vector<std::string> names_;
  std::size_t start_;
  std::vector<int> is_;  ///< 1 of the state that it is in, 0 of the others
  int free_, entered_, unlocked_;
  double lock_;
  std::string gears_;  ///< the output that is their ratio, if the states are gears
  std::vector<Output> outputs_;
  std::vector<Way> ways_;
};

void machine(Lowering& to, Arguments& a) { Machine(to, a).lower(); }

void keys_of_machine(text::KeyList& to) {
  to.need("states", Type::texts, "Names of its states.")
      .may("start", Type::text, "The state at the start; without it the first.")
      .may("entered", Type::number, "When it was entered; without it at the start.", {.unit = "s"})
      .may("lockout", Type::number, "After a transition the time in which none begins.",
           {.unit = "s", .otherwise = "0.0"})
      .may("gears", Type::text, "The output that is the ratio, of states that are gears.")
      .table("blocks.NAME.outputs",
             "Numbers by state: `BLOCK.NAME`, and `BLOCK.NAME_before` of the state before.")
      .may("NAME", Type::numbers, "One for each state.")
      .table("blocks.NAME.transitions[]", "Transitions; of two at one time the first is taken.", true)
      .need("from", Type::text, "The state that it leaves.")
      .need("to", Type::text, "The state that it enters.")
      .need("input", Type::signal, "What has to be above or below.")
      .may("above", Type::signal, "A threshold, or")
      .may("below", Type::signal, "one downwards.")
      .may("dwell", Type::number, "How long it has to hold.", {.unit = "s", .otherwise = "0.0"});
}

}  // namespace

const std::vector<BlockKind> machine_blocks = {
    {"machine", machine, "A state machine: the number of its state, from 1 on.", keys_of_machine}};

}  // namespace tandem::engine
