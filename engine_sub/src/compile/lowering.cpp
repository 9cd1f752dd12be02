// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "lowering.hpp"

#include <utility>

#include "refuse.hpp"

namespace tandem::engine {

Lowering::Lowering(const Description& diagram) {
  add({Slot::Kind::time, 0.0, "time"});
  names_["time"] = 0;
  for (const Input& input : diagram.inputs) {
    if (!names_.emplace(input.name, static_cast<int>(signals.size())).second)
      refuse(input.where, "the name '" + input.name + "' is there twice; allowed is a name of its own");
    add({Slot::Kind::input, 0.0, input.name});
  }
}

int Lowering::add(Slot signal) {
  if (block_) signal.block = block_->name;
  signals.push_back(std::move(signal));
  return static_cast<int>(signals.size()) - 1;
}

int Lowering::named(const std::string& name, const std::string& where) {
  const auto [it, is_new] = names_.emplace(name, static_cast<int>(signals.size()));
  if (is_new) signals.push_back({Slot::Kind::unknown, 0.0, name, "", where});
  return it->second;
}

void Lowering::define(const std::string& port, int signal) {
  const std::string name = port.empty() ? block_->name : block_->name + "." + port;
  Slot& entry = signals[named(name, "")];
  if (entry.kind != Slot::Kind::unknown || entry.same_as >= 0)
    refuse(block_->where, "the name '" + name + "' is there twice; allowed is a name of its own");
  entry.same_as = signal;
  if (signals[signal].name.empty()) signals[signal].name = name;
}

int Lowering::resolved(int signal) const {
  while (signals[signal].same_as >= 0) signal = signals[signal].same_as;
  return signal;
}

int Lowering::constant(double value) { return add({Slot::Kind::constant, value}); }

int Lowering::held(double start) { return add({Slot::Kind::held, start}); }

void Lowering::start(int slot, int from) {
  if (signals[from].kind == Slot::Kind::constant)
    signals[slot].start = signals[from].start;
  else
    starts.push_back({slot, from});
}

int Lowering::state(int rate) {
  Slot signal{Slot::Kind::state};
  signal.rate = rate;
  return add(signal);
}

int Lowering::operation(Operation::Code code, int a, int b, std::vector<double> p, int more) {
  const int out = add({Slot::Kind::result}), first = static_cast<int>(parameters.size());
  parameters.insert(parameters.end(), p.begin(), p.end());
  steps.push_back({out, {{code, out, a, b, more, first}}, block_ ? block_->name : ""});
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

int Lowering::crossing(int signal, Crossing::Direction direction) {
  events.push_back({Event::Kind::crossing, signal, held(0.0), direction});
  events.back().block = block_->name;
  return static_cast<int>(events.size()) - 1;
}

int Lowering::periodic(double period, double offset) {
  events.push_back({Event::Kind::periodic, -1, held(0.0)});
  events.back().period = period;
  events.back().offset = offset;
  events.back().block = block_->name;
  return static_cast<int>(events.size()) - 1;
}

int Lowering::mode(int wanted, const std::vector<int>& crossed) {
  const int mode = held(0.0);
  for (const int signal : crossed) update(crossing(signal, Crossing::Direction::both), mode, wanted);
  settled.push_back({mode, wanted});
  return mode;
}

}  // namespace tandem::engine
