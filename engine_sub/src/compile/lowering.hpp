// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lowered.hpp"
#include "tandem/engine/description.hpp"

namespace tandem::engine {

/// Collects what blocks come down to: signals, operations, events. Numbers of signals are its own.
class Lowering {
 public:
  explicit Lowering(const Description& diagram);

  /// Whose the signals and operations are that come next, until end() with what this gives.
  const Block* begin(const Block& block);
  void end(const Block* outside) { block_ = outside; }
  /// The block's name with those of the diagrams around it: "gearbox.clutch".
  std::string full_name(const std::string& block) const { return scopes_[scope_].prefix + block; }
  /// From here on names are those of a diagram in that block, until leave().
  struct Outside {
    int scope;
    const Block* block;
  };
  Outside enter(const std::string& block, const Description& diagram, int trigger);
  void leave(const Outside& outside);
  const Scope& scope() const { return scopes_[scope_]; }
  /// An input of the diagram that has been entered is this signal.
  void alias(const Input& input, int signal);

  /// The signal of that name, which may be defined later.
  int named(const std::string& name, const std::string& where);
  /// "block.port", or the block's own name where port is empty.
  void define(const std::string& port, int signal);

  int constant(double value);
  int time() const { return 0; }
  int state(int rate);
  int held(double start = 0.0);
  /// What a state or held value is at the start: a constant or a signal.
  void start(int slot, int from);
  int operation(Operation::Code code, int a, int b, std::vector<double> parameters = {}, int more = 0);
  int linear(double constant, double factor, int a) {
    return operation(Operation::Code::linear, a, 0, {constant, factor});
  }
  int difference(int a, int b) { return operation(Operation::Code::sum, a, b, {1.0, -1.0}); }
  int sum(const std::vector<int>& signals, const std::vector<double>& factors);
  int curve(Curve curve, int a);
  int surface(Surface surface, int a, int b);
  /// Of time; steps end at its kinks and jumps.
  int data(TimeSeries data);
  /// Signals made one after the other stay so, and all are there if one is.
  void keep_together(const std::vector<int>& signals);
  /// Copies of signals, together; -1 for none. Returns the first.
  int gathered(const std::vector<int>& from);
  struct Call {
    CompiledBlock::Function function;
    int states, inputs;  ///< the first; -1 for none
    int results;
  };
  /// Its results, together.
  std::vector<int> call(const Call& call, const std::vector<double>& parameters);
  /// `from` as it was `time` seconds before; `initial` before the start.
  int delay(int from, int initial, double time, int points);
  /// Refuses values of a signal outside of range.low to range.high, where something depends on `user`.
  void range(int user, Range range) { guards.push_back({user, std::move(range)}); }

  /// The event when a signal changes its sign; of what it does the others can be added.
  int crossing(int signal, Crossing::Direction direction);
  int periodic(double period, double offset);
  void watch(const Limit& limit);
  /// The beginning of each own step.
  int own_step();
  void update(int event, int to, int from) { events[event].updates.push_back({to, from}); }
  /// A held mode that is `wanted` after an event of any of these signals' signs, and at the start.
  int mode(int wanted, const std::vector<int>& signals);
  void kink(double t) { breaks.push_back(t); }

  /// Follows names to what they stand for.
  int resolved(int signal) const;
  /// Refuses names that stand for one another in a circle.
  void refuse_circles() const;

  std::vector<Slot> signals;
  std::vector<Step> steps;
  std::vector<Event> events;
  std::vector<Update> starts, settled;
  std::vector<double> parameters, breaks;
  std::vector<Curve> curves;
  std::vector<Surface> surfaces;
  std::vector<TimeSeries> series;
  std::vector<DataJumps> data_jumps;
  std::vector<CompiledBlock::Function> calls;
  std::vector<Delay> delays;
  const std::vector<CompiledBlock>& kinds;
  struct Guard {
    int user;
    Range range;
  };
  std::vector<Guard> guards;
  std::vector<Bound> bounds;
  /// A signal that must be above another one wherever that can be seen before a run.
  struct Order {
    int above, below;
    std::string where, owner, high, low;  ///< the last two: what they are
  };
  std::vector<Order> orders;
  /// A port that says the unit of its signal.
  struct PortUnit {
    int signal;
    std::string unit, name, where;
  };
  std::vector<PortUnit> port_units;
  std::vector<std::pair<int, int>> same_units;  ///< of signals, whichever it is
  std::vector<std::string> blocks;              ///< full names of those that have begun
  std::map<std::string, std::string> places;    ///< of all by full name: "FILE:LINE"

 private:
  int add(Slot signal);
  int event(Event::Kind kind, int signal);
  void bound(const Limit& limit, int beyond, const std::string& what);
  void refuse_if_triggered(const std::string& what) const;
  std::map<std::pair<int, std::string>, int> names_;
  std::vector<Scope> scopes_;
  int scope_ = 0;
  const Block* block_ = nullptr;
};

}  // namespace tandem::engine
