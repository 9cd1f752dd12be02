// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/compile.hpp"

#include <algorithm>

#include "blocks/kinds.hpp"
#include "order.hpp"
#include "read/reader.hpp"
#include "refuse.hpp"
#include "tandem/nearest.hpp"
#include "units.hpp"
#include "write.hpp"

namespace tandem::engine {
namespace {

/// Names that are known in a scope.
std::vector<std::string> known_signals(const Lowering& d, int scope) {
  std::vector<std::string> known;
  for (const Slot& s : d.signals)
    if (!s.name.empty() && s.scope == scope && (s.kind != Slot::Kind::unknown || s.same_as >= 0))
      known.push_back(s.name);
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  return known;
}

void refuse_unknown_signals(const Lowering& d) {
  for (const Slot& s : d.signals)
    if (s.kind == Slot::Kind::unknown && s.same_as < 0)
      refuse(s.where, (s.user.empty() ? "" : "block '" + s.user + "': ") +
                          unknown("signal", s.name, known_signals(d, s.scope)));
}

}  // namespace

const std::vector<BlockKind>& kinds_of_blocks() {
  static const std::vector<BlockKind> all = [] {
    std::vector<BlockKind> kinds;
    for (const auto* list : {&source_blocks, &algebraic_blocks, &table_blocks, &nonlinear_blocks,
                             &dynamic_blocks, &discrete_blocks, &machine_blocks, &nested_blocks})
      kinds.insert(kinds.end(), list->begin(), list->end());
    return kinds;
  }();
  return all;
}

static void lower_own(const BlockKind& kind, const Block& block, Lowering& to) {
  Arguments arguments(block, to, &language_of_diagrams());
  kind.lower(to, arguments);
  arguments.refuse_unknown();
}

static void lower_compiled(const CompiledBlock& kind, const Block& block, Lowering& to) {
  Arguments arguments(block, to, nullptr);
  lower_compiled(kind, to, arguments);
  arguments.refuse_unknown();
}

void lower(const Block& block, Lowering& to) {
  std::vector<std::string> known;
  for (const BlockKind& kind : kinds_of_blocks()) known.emplace_back(kind.name);
  for (const CompiledBlock& kind : to.kinds) known.push_back(kind.kind);
  if (std::find(known.begin(), known.end(), block.kind) == known.end())
    refuse(block.place("kind"),
           "block '" + to.full_name(block.name) + "': " + unknown("kind", block.kind, known));
  const Block* const outside = to.begin(block);
  for (const BlockKind& kind : kinds_of_blocks())
    if (block.kind == kind.name) lower_own(kind, block, to);
  for (const CompiledBlock& kind : to.kinds)
    if (block.kind == kind.kind) lower_compiled(kind, block, to);
  keep_units(block, to);
  to.end(outside);
}

void lower_contents(const Description& diagram, Lowering& to) {
  for (const Block& block : diagram.blocks) lower(block, to);
  for (const Limit& limit : diagram.limits) to.watch(limit);
}

Program compile(const Description& diagram) {
  Lowering lowered(diagram);
  lower_contents(diagram, lowered);
  std::vector<int> outputs;
  for (const Output& output : diagram.outputs) {
    const auto* name = std::get_if<std::string>(&output.from);
    outputs.push_back(name ? lowered.named(*name, output.where)
                           : lowered.constant(std::get<double>(output.from)));
    lowered.port_units.push_back({outputs.back(), output.unit, "output '" + output.name + "'", output.where});
  }
  for (const auto& [name, value] : diagram.loops.guess) lowered.named(name, diagram.loops.where);
  lowered.refuse_circles();
  refuse_unknown_signals(lowered);
  refuse_mixed_units(lowered);
  refuse_disorder(lowered);
  return write_program(lowered, outputs, diagram.loops);
}

}  // namespace tandem::engine
