// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/diagram_info.hpp"
#include "cli/say.hpp"
#include "engine_models/compiled.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

using engine::Block;
using engine::Description;

/// A diagram, and where it stands.
struct Scope {
  const Description& diagram;
  std::string prefix = {};  ///< "gearbox.", before the names of its blocks
  const Scope* outside = nullptr;
  const Block* block = nullptr;  ///< of `outside`, that holds it

  Scope inside(const Block& of) const { return {*of.diagram, prefix + of.name + ".", this, &of}; }
};

template <class List>
const typename List::value_type* find(const List& list, const std::string& name) {
  const auto it =
      std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
  return it == list.end() ? nullptr : &*it;
}

std::string source_of(const Scope& scope, const engine::Wire& wire);

/// Of a diagram in a block: what its output comes from.
std::string inner_source(const Scope& scope, const Block& block, const std::string& port) {
  const auto& outputs = block.diagram->outputs;
  const auto* output = port.empty() && outputs.size() == 1 ? &outputs[0] : find(outputs, port);
  return output ? source_of(scope.inside(block), output->from) : "";
}

/// The node that makes a signal, through the diagrams in blocks; empty for a number or a name that is none.
std::string source_of(const Scope& scope, const engine::Wire& wire) {
  const auto* name = std::get_if<std::string>(&wire);
  if (!name) return "";
  if (*name == "time") return *name;
  if (find(scope.diagram.inputs, *name)) {
    if (!scope.outside) return *name;
    const auto it = scope.block->values.find(*name);
    const auto* text = it == scope.block->values.end() ? nullptr : std::get_if<std::string>(&it->second);
    return text ? source_of(*scope.outside, *text) : "";
  }
  const auto dot = name->find('.');
  const Block* block = find(scope.diagram.blocks, name->substr(0, dot));
  if (!block) return "";
  if (block->diagram)
    return inner_source(scope, *block, dot == std::string::npos ? "" : name->substr(dot + 1));
  return scope.prefix + block->name;
}

/// Those keys of a block whose texts are signals.
bool is_port(const std::string& key) {
  static const std::set<std::string> words = {
      "function", "interpolation", "beyond", "states", "start", "from", "to", "file", "column"};
  return words.count(key) == 0;
}

/// Prints nodes in the frames of their diagrams and gathers edges, which in Graphviz would take their nodes
/// into the frame that they stand in.
class Graph {
 public:
  explicit Graph(std::set<std::string> left_out) : left_out_(std::move(left_out)) {}

  void contents(const Scope& scope) {
    for (const Block& block : scope.diagram.blocks)
      block.diagram ? nested(scope, block) : plain(scope, block);
    for (const auto& limit : scope.diagram.limits) {
      const std::string name = "limit " + scope.prefix + limit.name;
      say("  \"{}\" [shape=octagon, label=\"{}\\n{} .. {}\"];\n", name, limit.name, limit.low, limit.high);
      edge(scope, limit.signal, name, "");
    }
  }
  void edge(const Scope& scope, const engine::Wire& from, const std::string& to, const std::string& label) {
    const std::string node = source_of(scope, from);
    if (!node.empty()) edges += fmt::format("  \"{}\" -> \"{}\" [label=\"{}\"];\n", node, to, label);
  }

  std::string edges;

 private:
  void plain(const Scope& scope, const Block& block) {
    const std::string name = scope.prefix + block.name;
    say("  \"{}\" [label=\"{}\\n{}\"{}];\n", name, block.name, block.kind,
        left_out_.count(name) ? ", style=dashed" : "");
    ports(scope, block, name);
  }

  /// Of a block and of the tables in it.
  void ports(const Scope& scope, const Block& block, const std::string& to) {
    for (const auto& [key, value] : block.values) {
      if (!is_port(key)) continue;
      if (const auto* text = std::get_if<std::string>(&value)) edge(scope, *text, to, key);
      if (const auto* list = std::get_if<std::vector<engine::Wire>>(&value))
        for (const engine::Wire& wire : *list) edge(scope, wire, to, "");
    }
    for (const auto& [key, tables] : block.tables)
      for (const Block& table : tables) ports(scope, table, to);
  }

  void nested(const Scope& scope, const Block& block) {
    const std::string name = scope.prefix + block.name;
    say("  subgraph \"cluster {0}\" {{\n  label=\"{0}\";\n", name);
    contents(scope.inside(block));
    say("  }}\n");
    if (block.kind != "triggered") return;
    say("  \"{0}\" [label=\"{0}\\ntriggered\"];\n", name);
    const auto it = block.values.find("trigger");
    const auto* text = it == block.values.end() ? nullptr : std::get_if<std::string>(&it->second);
    if (text) edge(scope, *text, name, "trigger");
  }

  std::set<std::string> left_out_;
};

void print_graph(const Description& diagram, const std::vector<std::string>& left_out) {
  say("digraph \"{}\" {{\n  rankdir=LR;\n  newrank=true;\n  node [shape=box];\n", diagram.name);
  for (const auto& input : diagram.inputs)
    say("  \"{}\" [shape=cds, label=\"{} [{}]\"];\n", input.name, input.name, input.unit);
  const Scope scope{diagram};
  Graph graph({left_out.begin(), left_out.end()});
  graph.contents(scope);
  for (const auto& output : diagram.outputs) {
    say("  \"out {}\" [shape=cds, label=\"{} [{}]\"];\n", output.name, output.name, output.unit);
    graph.edge(scope, output.from, "out " + output.name, "");
  }
  say("{}}}\n", graph.edges);
}

}  // namespace

void print_dot(const text::Document& document) {
  Description diagram = engine::read_diagram(document);
  diagram.kinds = engine_models::compiled_kinds();
  try {
    print_graph(diagram, engine::compile(diagram).left_out);
  } catch (const Error&) {
    print_graph(diagram, {});
    throw;
  }
}

}  // namespace tandem::cli
