// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/diagram_info.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/document.hpp"

namespace tandem::cli {
namespace {

/// Events by block, each block once.
std::vector<std::string> event_blocks(const engine::Program& program) {
  std::set<std::string> names;
  for (const auto& crossing : program.crossings) names.insert(crossing.name);
  for (const auto& periodic : program.periodics) names.insert(periodic.name);
  return {names.begin(), names.end()};
}

std::vector<std::string> inputs_of(const engine::Description& diagram, const engine::Program& program,
                                   int output) {
  std::vector<std::string> names;
  for (const auto& [to, from] : program.feedthrough)
    if (to == output) names.push_back(diagram.inputs[static_cast<std::size_t>(from)].name);
  return names;
}

/// An edge of the graph from a signal's block, if it is one.
void print_edge(const engine::Wire& from, const std::string& to, const std::string& label) {
  const auto* name = std::get_if<std::string>(&from);
  if (name) fmt::print("  \"{}\" -> \"{}\" [label=\"{}\"];\n", name->substr(0, name->find('.')), to, label);
}

/// Those keys of a block whose texts are signals.
bool is_port(const std::string& key) {
  static const std::set<std::string> words = {"function", "interpolation", "beyond"};
  return words.count(key) == 0;
}

}  // namespace

bool is_diagram(const std::filesystem::path& file) { return text::Document(file).table().contains("blocks"); }

void print_diagram(const std::filesystem::path& file) {
  const engine::Description diagram = engine::read_diagram(file);
  const engine::Program program = engine::compile(diagram);
  fmt::print("{}: a diagram of {} blocks, {} operations\n", diagram.name, diagram.blocks.size(),
             program.operations.size());
  fmt::print("  order {}: {}\n", program.states, listed(program.state_names));
  for (const auto& p : diagram.parameters) fmt::print("  parameter {} = {} {}\n", p.name, p.value, p.unit);
  for (const auto& input : diagram.inputs) fmt::print("  input {} [{}]\n", input.name, input.unit);
  for (std::size_t k = 0; k < diagram.outputs.size(); ++k)
    fmt::print("  output {} [{}], follows at once: {}\n", diagram.outputs[k].name, diagram.outputs[k].unit,
               listed(inputs_of(diagram, program, static_cast<int>(k))));
  fmt::print("  {} signals watched for events; periodic events: {}; of the blocks {}\n",
             program.crossings.size(), program.periodics.size(), listed(event_blocks(program)));
  for (const std::string& notice : program.notices) fmt::print("  {}\n", notice);
}

void print_dot(const std::filesystem::path& file) {
  const engine::Description diagram = engine::read_diagram(file);
  engine::compile(diagram);
  fmt::print("digraph \"{}\" {{\n  rankdir=LR;\n  node [shape=box];\n", diagram.name);
  for (const auto& input : diagram.inputs)
    fmt::print("  \"{}\" [shape=cds, label=\"{} [{}]\"];\n", input.name, input.name, input.unit);
  for (const auto& block : diagram.blocks) {
    fmt::print("  \"{}\" [label=\"{}\\n{}\"];\n", block.name, block.name, block.kind);
    for (const auto& [key, value] : block.values) {
      if (const auto* text = std::get_if<std::string>(&value); text && is_port(key))
        print_edge(*text, block.name, key);
      if (const auto* list = std::get_if<std::vector<engine::Wire>>(&value))
        for (const engine::Wire& wire : *list) print_edge(wire, block.name, "");
    }
  }
  for (const auto& output : diagram.outputs) {
    fmt::print("  \"out {}\" [shape=cds, label=\"{} [{}]\"];\n", output.name, output.name, output.unit);
    print_edge(output.from, "out " + output.name, "");
  }
  fmt::print("}}\n");
}

}  // namespace tandem::cli
