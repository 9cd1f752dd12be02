// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "lowering.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "past.hpp"
#include "refuse.hpp"

namespace tandem::engine {

Lowering::Lowering(const Description& diagram) : kinds(diagram.kinds), scopes_{{"", diagram.folder}} {
  add({Slot::Kind::time, 0.0, "time"});
  names_[{0, "time"}] = 0;
  for (const Input& input : diagram.inputs) {
    alias(input, static_cast<int>(signals.size()));
    port_units.push_back(
        {add({Slot::Kind::input, 0.0, input.name}), input.unit, "input '" + input.name + "'", input.where});
  }
}

const Block* Lowering::begin(const Block& block) {
  const Block* const outside = std::exchange(block_, &block);
  if (!block.diagram) blocks.push_back(full_name(block.name));
  places[full_name(block.name)] = block.where;
  return outside;
}

Lowering::Outside Lowering::enter(const std::string& block, const Description& diagram, int trigger) {
  const Outside outside{scope_, block_};
  const bool is_triggered = trigger >= 0;
  scopes_.push_back({full_name(block) + ".", diagram.folder, is_triggered ? trigger : scope().trigger});
  scope_ = static_cast<int>(scopes_.size()) - 1;
  names_[{scope_, "time"}] = 0;
  return outside;
}

void Lowering::leave(const Outside& outside) { scope_ = outside.scope, block_ = outside.block; }

void Lowering::alias(const Input& input, int signal) {
  if (!names_.emplace(std::pair(scope_, input.name), signal).second)
    refuse(input.where,
           "the name '" + full_name(input.name) + "' is there twice; allowed is a name of its own");
}

int Lowering::add(Slot signal) {
  if (block_) signal.block = full_name(block_->name);
  signals.push_back(std::move(signal));
  return static_cast<int>(signals.size()) - 1;
}

int Lowering::named(const std::string& name, const std::string& where) {
  const auto [it, is_new] = names_.emplace(std::pair(scope_, name), static_cast<int>(signals.size()));
  if (is_new) {
    signals.push_back({Slot::Kind::unknown, 0.0, full_name(name), "", where});
    signals.back().scope = scope_;
    if (block_) signals.back().user = full_name(block_->name);
  }
  return it->second;
}

void Lowering::define(const std::string& port, int signal) {
  const std::string name = port.empty() ? block_->name : block_->name + "." + port;
  Slot& entry = signals[named(name, "")];
  if (entry.kind != Slot::Kind::unknown || entry.same_as >= 0)
    refuse(block_->where, "the name '" + full_name(name) + "' is there twice; allowed is a name of its own");
  entry.same_as = signal;
  if (signals[signal].name.empty()) signals[signal].name = full_name(name);
}

int Lowering::resolved(int signal) const {
  while (signals[signal].same_as >= 0) signal = signals[signal].same_as;
  return signal;
}

void Lowering::refuse_circles() const {
  for (const Slot& first : signals) {
    std::size_t names = 0;
    for (int next = first.same_as; next >= 0; next = signals[next].same_as)
      if (++names > signals.size())
        refuse("", "the signal '" + first.name + "' stands for itself; allowed is a block in between");
  }
}

int Lowering::constant(double value) { return add({Slot::Kind::constant, value}); }

int Lowering::held(double start) { return add({Slot::Kind::held, start}); }

void Lowering::start(int slot, int from) {
  if (signals[from].kind == Slot::Kind::constant)
    signals[slot].start = signals[from].start;
  else
    starts.push_back({slot, from});
}

void Lowering::refuse_if_triggered(const std::string& what) const {
  if (scope().trigger < 0) return;
  refuse(block_->where, "block '" + full_name(block_->name) + "' of kind " + block_->kind + " has " + what +
                            ", but stands in a triggered diagram; allowed there is what has neither events "
                            "nor states");
}

int Lowering::state(int rate) {
  refuse_if_triggered("states");
  Slot signal{Slot::Kind::state};
  signal.rate = rate;
  return add(signal);
}

int Lowering::operation(Operation::Code code, int a, int b, std::vector<double> p, int more) {
  const int out = add({Slot::Kind::result}), first = static_cast<int>(parameters.size());
  parameters.insert(parameters.end(), p.begin(), p.end());
  steps.push_back({out, {{code, out, a, b, more, first}}, block_ ? full_name(block_->name) : ""});
  return out;
}

int Lowering::sum(const std::vector<int>& terms, const std::vector<double>& factors) {
  if (terms.size() == 1) return linear(0.0, factors[0], terms[0]);
  const int out = operation(Operation::Code::sum, terms[0], terms[1], {factors[0], factors[1]});
  for (std::size_t k = 2; k < terms.size(); ++k) {
    steps.back().operations.push_back(
        {Operation::Code::add, out, terms[k], 0, 0, static_cast<int>(parameters.size())});
    parameters.push_back(factors[k]);
  }
  return out;
}

int Lowering::curve(Curve curve, int a) {
  curves.push_back(std::move(curve));
  return operation(Operation::Code::curve, a, static_cast<int>(curves.size()) - 1);
}

int Lowering::surface(Surface surface, int a, int b) {
  surfaces.push_back(std::move(surface));
  return operation(Operation::Code::surface, a, b, {}, static_cast<int>(surfaces.size()) - 1);
}

int Lowering::data(TimeSeries data) {
  const auto number = static_cast<int>(series.size());
  const int run = data.jumps().empty() ? constant(0.0) : held(0.0);
  if (!data.jumps().empty()) data_jumps.push_back({number, run, full_name(block_->name)});
  for (const double t : data.kinks()) kink(t);
  const int of = data.degree() == 0 ? run : time();  // held: the run says all
  series.push_back(std::move(data));
  return operation(Operation::Code::data, of, number, {}, run);
}

void Lowering::keep_together(const std::vector<int>& together) {
  for (const int signal : together) {
    signals[signal].first = together.front();
    signals[signal].count = static_cast<int>(together.size());
  }
}

int Lowering::gathered(const std::vector<int>& from) {
  if (from.empty()) return -1;
  std::vector<int> copies;
  for (const int signal : from) copies.push_back(linear(0.0, 1.0, signal));
  keep_together(copies);
  return copies.front();
}

std::vector<int> Lowering::call(const Call& call, const std::vector<double>& p) {
  calls.push_back(call.function);
  std::vector<int> results = {
      operation(Operation::Code::call, call.states, call.inputs, p, static_cast<int>(calls.size()) - 1)};
  while (static_cast<int>(results.size()) < call.results) results.push_back(add({Slot::Kind::result}));
  steps.back().count = call.results;
  keep_together(results);
  return results;
}

int Lowering::delay(int from, int initial, double time, int points) {
  refuse_if_triggered("a past");
  const int past = add({Slot::Kind::past});
  signals[past].size = Past::size(points);
  start(past, initial);
  delays.push_back({past, points, from, time, full_name(block_->name)});
  return operation(Operation::Code::delay, past, static_cast<int>(delays.size()) - 1, {time}, this->time());
}

int Lowering::event(Event::Kind kind, int signal) {
  refuse_if_triggered("events of its own");
  events.push_back({kind, signal, kind == Event::Kind::own_step ? -1 : held(0.0)});
  events.back().block = full_name(block_->name);
  return static_cast<int>(events.size()) - 1;
}

int Lowering::crossing(int signal, Crossing::Direction direction) {
  const int number = event(Event::Kind::crossing, signal);
  events[number].direction = direction;
  return number;
}

int Lowering::periodic(double period, double offset) {
  const int number = event(Event::Kind::periodic, -1);
  events[number].period = period;
  events[number].offset = offset;
  return number;
}

/// Two events: below and above.
void Lowering::watch(const Limit& limit) {
  if (!(limit.low < limit.high))
    refuse(limit.where, fmt::format("limit '{}': low is {}; allowed is below high, {}", full_name(limit.name),
                                    limit.low, limit.high));
  if (scope().trigger >= 0)
    refuse(limit.where, "limit '" + full_name(limit.name) +
                            "' stands in a triggered diagram; allowed is one in the diagram around it");
  if (limit.on_leaving == Limit::OnLeaving::ignore) return;
  const Block* const block = std::exchange(block_, nullptr);
  const auto* name = std::get_if<std::string>(&limit.signal);
  const int x = name ? named(*name, limit.where) : constant(std::get<double>(limit.signal));
  const std::string what =
      fmt::format("limit '{}': signal '{}' is ", full_name(limit.name), name ? full_name(*name) : "a number");
  if (std::isfinite(limit.low))
    bound(limit, linear(limit.low, -1.0, x), what + fmt::format("below {}", limit.low));
  if (std::isfinite(limit.high))
    bound(limit, linear(-limit.high, 1.0, x), what + fmt::format("above {}", limit.high));
  block_ = block;
}

void Lowering::bound(const Limit& limit, int beyond, const std::string& what) {
  events.push_back({Event::Kind::crossing, beyond, held(0.0)});
  events.back().block = full_name(limit.name);
  events.back().bound = static_cast<int>(bounds.size());
  bounds.push_back({what, limit.sentence, limit.on_leaving == Limit::OnLeaving::stop});
}

int Lowering::own_step() { return event(Event::Kind::own_step, -1); }

int Lowering::mode(int wanted, const std::vector<int>& crossed) {
  if (scope().trigger >= 0) return wanted;
  const int mode = held(0.0);
  for (const int signal : crossed) {
    const int event = crossing(signal, Crossing::Direction::both);
    events[event].effect = Event::Effect::mode;
    update(event, mode, wanted);
  }
  settled.push_back({mode, wanted});
  return mode;
}

}  // namespace tandem::engine
