// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "compile/refuse.hpp"
#include "kinds.hpp"
#include "tandem/engine/compiled_block.hpp"

namespace tandem::engine {
namespace {

/// A parameter, or what it is if it is not given.
double parameter(Arguments& a, const CompiledBlock::Quantity& q) {
  return std::isnan(q.otherwise) || a.has(q.name) ? a.number(q.name) : q.otherwise;
}

void check(const CompiledBlock& kind, const Arguments& a) {
  if (kind.output && !kind.outputs.empty() && (kind.states.empty() || kind.rates)) return;
  refuse(a.where(),
         a.owner() + " is written in C++ without " +
             (kind.output ? kind.outputs.empty() ? "outputs" : "rates of its states" : "an output function") +
             "; allowed is a CompiledBlock that has them");
}

}  // namespace

void lower_compiled(const CompiledBlock& kind, Lowering& to, Arguments& a) {
  check(kind, a);
  std::vector<double> p;
  for (const auto& q : kind.parameters) p.push_back(parameter(a, q));
  std::vector<int> u, x;
  for (const auto& name : kind.inputs) u.push_back(a.wire(name));
  for (std::size_t k = 0; k < kind.states.size(); ++k) x.push_back(to.state(-1));
  to.keep_together(x);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto& q = kind.states[k];
    to.start(x[k], std::isnan(q.otherwise) || a.has(q.name) ? a.wire(q.name) : to.constant(q.otherwise));
  }
  const int states = x.empty() ? -1 : x[0], inputs = to.gathered(u);
  const auto y = to.call(
      {kind.output, states, kind.feedthrough ? inputs : -1, static_cast<int>(kind.outputs.size())}, p);
  if (!x.empty()) {
    const auto dx = to.call({kind.rates, states, inputs, static_cast<int>(x.size())}, p);
    for (std::size_t k = 0; k < x.size(); ++k) to.signals[x[k]].rate = dx[k];
  }
  for (std::size_t k = 0; k < y.size(); ++k) to.define(kind.outputs[k], y[k]);
  if (y.size() == 1) to.define("", y[0]);
}

}  // namespace tandem::engine
