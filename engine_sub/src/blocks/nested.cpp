// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "compile/refuse.hpp"
#include "kinds.hpp"

namespace tandem::engine {
namespace {

/// Lowers the diagram in a block, evaluated at an event alone if one is given, and gives its outputs.
std::vector<int> contents(Lowering& to, Arguments& a, int trigger) {
  const Description* inner = a.block().diagram.get();
  if (!inner)
    refuse(a.where(),
           a.owner() + " has no diagram; allowed is file, the name of its file, or diagram, a table");
  std::vector<int> inputs, outputs;
  for (const Input& input : inner->inputs) inputs.push_back(a.wire(input.name));
  const auto outside = to.enter(a.block().name, *inner, trigger);
  for (std::size_t k = 0; k < inputs.size(); ++k) to.alias(inner->inputs[k], inputs[k]);
  for (const Block& block : inner->blocks) lower(block, to);
  for (const Output& output : inner->outputs) {
    const auto* name = std::get_if<std::string>(&output.from);
    outputs.push_back(name ? to.named(*name, output.where) : to.constant(std::get<double>(output.from)));
  }
  to.leave(outside);
  return outputs;
}

/// "BLOCK.output" for each, and the block's own name where there is one.
void define(Lowering& to, const Description& inner, const std::vector<int>& outputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) to.define(inner.outputs[k].name, outputs[k]);
  if (outputs.size() == 1) to.define("", outputs[0]);
}

void diagram(Lowering& to, Arguments& a) {
  const auto outputs = contents(to, a, -1);
  define(to, *a.block().diagram, outputs);
}

/// Its outputs are held from event to event; before the first they are what the diagram gives at the start.
void triggered(Lowering& to, Arguments& a) {
  const int event = a.has("period") ? to.periodic(a.positive("period"), a.number("offset", 0.0))
                                    : to.crossing(a.wire("trigger"), Crossing::Direction::rising);
  std::vector<int> held;
  for (const int output : contents(to, a, event)) {
    held.push_back(to.held());
    to.start(held.back(), output);
    to.update(event, held.back(), output);
  }
  define(to, *a.block().diagram, held);
}

}  // namespace

const std::vector<BlockKind> nested_blocks = {{"diagram", diagram}, {"triggered", triggered}};

}  // namespace tandem::engine
