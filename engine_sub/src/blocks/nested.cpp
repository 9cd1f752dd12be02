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
  for (const Input& input : inner->inputs) {
    inputs.push_back(a.wire(input.name));
    to.port_units.push_back(
        {inputs.back(), input.unit, a.owner() + ": input '" + input.name + "'", a.where()});
  }
  const auto outside = to.enter(a.block().name, *inner, trigger);
  for (std::size_t k = 0; k < inputs.size(); ++k) to.alias(inner->inputs[k], inputs[k]);
  lower_contents(*inner, to);
  for (const Output& output : inner->outputs) {
    const auto* name = std::get_if<std::string>(&output.from);
    outputs.push_back(name ? to.named(*name, output.where) : to.constant(std::get<double>(output.from)));
  }
  to.leave(outside);
  return outputs;
}

/// "BLOCK.output" for each, and the block's own name where there is one.
void define(Lowering& to, const Arguments& a, const std::vector<int>& outputs) {
  const Description& inner = *a.block().diagram;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const Output& output = inner.outputs[k];
    to.define(output.name, outputs[k]);
    to.port_units.push_back(
        {outputs[k], output.unit, a.owner() + ": output '" + output.name + "'", output.where});
  }
  if (outputs.size() == 1) to.define("", outputs[0]);
}

void diagram(Lowering& to, Arguments& a) {
  const auto outputs = contents(to, a, -1);
  define(to, a, outputs);
}

/// Its outputs are held from event to event; before the first they are what the diagram gives at the start.
void triggered(Lowering& to, Arguments& a) {
  const int event = a.has("period") ? to.periodic(a.positive("period"), a.number("offset"))
                                    : to.crossing(a.wire("trigger"), Crossing::Direction::rising);
  std::vector<int> held;
  for (const int output : contents(to, a, event)) {
    held.push_back(to.held());
    to.start(held.back(), output);
    to.update(event, held.back(), output);
  }
  define(to, a, held);
}

void keys_of_diagram(text::KeyList& to) {
  to.may("file", Type::text, "Its file, from the diagram's folder, or")
      .may("diagram", Type::itself, "the diagram itself.")
      .may("NAME", Type::signal,
           "An input of that diagram: its signal; or another value of a parameter of it.");
}

}  // namespace

const std::vector<BlockKind> nested_blocks = {
    {"diagram", diagram, "A diagram in a block.", keys_of_diagram},
    {"triggered", triggered, "A diagram that is evaluated at events alone, and held between.",
     [](text::KeyList& to) {
       keys_of_diagram(to);
       to.may("trigger", Type::signal, "Where this rises above 0 there is an event, or")
           .may("period", Type::positive, "from event to event.", {.unit = "s"})
           .may("offset", Type::number, "When the first is, from the start of the run.",
                {.unit = "s", .otherwise = "0.0"});
     }}};

}  // namespace tandem::engine
