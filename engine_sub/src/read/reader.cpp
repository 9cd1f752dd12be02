// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/engine/keys.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/limits.hpp"

namespace tandem::engine {

namespace fs = std::filesystem;

const text::Keys& language_of_diagrams() {
  static const text::Keys all = diagram_keys();
  return all;
}

Description DiagramReader::read() {
  to_.name = root_.text("name").value_or(document().file());
  to_.folder = fs::path(document().file()).parent_path();
  root_.text("description");
  for (const text::FileParameter& p : text::read_parameters(root_, given_.values, values_)) {
    if (p.allowed_word) given_.bounded.erase(p.name);
    to_.parameters.push_back({p.name, p.unit, p.value});
  }
  each("inputs", [this](auto& name, Section& s) {
    to_.inputs.push_back({name, s.required_text("unit"), s.place().text()});
  });
  read_blocks();
  each("outputs", [this](auto& name, Section& s) { read_output(name, s); });
  each("limits", [this](auto& name, Section& s) { read_limit(name, s); });
  read_loops();
  root_.section("run");  // for whoever runs it
  root_.refuse_unknown();
  if (to_.blocks.empty()) root_.missing("blocks", "a table [blocks.NAME] for each block");
  return std::move(to_);
}

void DiagramReader::read_loops() {
  auto section = root_.section("loops");
  if (!section) return;
  LoopSettings& loops = to_.loops;
  loops.where = section->place().text();
  loops.solve = *section->flag("solve");
  loops.tolerance = *section->positive("tolerance");
  const double most = *section->positive("most_iterations");
  if (most < 1.0 || most > 1e6) section->wrong("most_iterations", fmt::format("{}", most), "1 to 1e6");
  loops.most_iterations = static_cast<int>(most);
  if (const toml::table* guesses = section->table("guess"))
    for (const auto& [signal, node] : text::in_file_order(*guesses))
      loops.guess[signal] = values_.number(document(), *node, section->name("guess." + signal));
  section->refuse_unknown();
}

/// Calls read(name, section) for each table below a key, in the order of the file.
template <class Read>
void DiagramReader::each(const std::string& key, const Read& read) {
  auto table = root_.section(key);
  if (!table) return;
  for (auto& [name, section] : table->named_sections()) {
    read(name, section);
    section.refuse_unknown();
  }
}

/// Their keys are known when they are compiled, as kinds of them may be written in C++.
void DiagramReader::read_blocks() {
  auto table = root_.section("blocks");
  if (!table) return;
  for (const auto& [name, known] : table->named_sections()) {
    Section section(document(), known.table(), known.path(), &values_);
    read_block(name, section);
    section.refuse_unknown();
  }
}

/// A number, or a text; or what a text stands for that begins with $.
Wire DiagramReader::wire(const toml::node& node, const std::string& key) const {
  if (!node.is_string()) return text::number_of(document(), node, key);
  if (!text::Values::refers(node)) return node.as_string()->get();
  const text::FileValue found = values_.value(document(), node, key);
  if (const auto* number = std::get_if<double>(&found)) return *number;
  return std::get<std::string>(found);
}

/// Whether it is "$NAME" of a parameter with a value that names files only below a folder.
bool DiagramReader::is_bounded(const toml::node& node) const {
  const auto text = node.value<std::string>();
  return text && text->starts_with("$") && given_.bounded.contains(text->substr(1));
}

void DiagramReader::refuse_beyond_bounds(const toml::node& node, const std::string& key) const {
  if (!is_bounded(node)) return;
  const Wire name = wire(node, key);
  if (const auto* file = std::get_if<std::string>(&name); file && !files_.in_bounds(to_.folder / *file))
    text::refuse(
        document().place(node),
        fmt::format("{} is '{}'; allowed from a client is what stands in the diagram, or a file below "
                    "its folder",
                    key, *file));
}

Value DiagramReader::value(const toml::node& node, const std::string& key) const {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const toml::array* array = node.as_array()) {
    std::vector<Wire> all;
    for (const toml::node& item : *array) all.push_back(wire(item, fmt::format("{}[{}]", key, all.size())));
    return all;
  }
  const Wire one = wire(node, key);
  if (const auto* number = std::get_if<double>(&one)) return *number;
  return std::get<std::string>(one);
}

void DiagramReader::read_block(const std::string& name, Section& section) {
  files_.count_block(section.place());
  Block block{name, section.required_text("kind", "the kind of the block"), {}, section.place().text()};
  block.places.emplace("kind", section.place("kind").text());
  if (block.kind == "diagram" || block.kind == "triggered")
    read_nested(block, section);
  else
    read_values(block, section, {"kind"});
  to_.blocks.push_back(std::move(block));
}

void DiagramReader::read_values(Block& block, Section& section, const std::vector<std::string>& besides) {
  for (const auto& [key, node] : text::in_file_order(section.table())) {
    if (std::find(besides.begin(), besides.end(), key) != besides.end()) continue;
    section.node(key);
    block.places.emplace(key, document().place(*node).text());
    if (key == "file") refuse_beyond_bounds(*node, section.name(key));
    if (!read_tables(block, key, *node, section)) block.values.emplace(key, value(*node, section.name(key)));
  }
}

/// Whether it is a table or an array of tables.
bool DiagramReader::read_tables(Block& block, const std::string& key, const toml::node& node,
                                const Section& section) {
  std::vector<const toml::table*> tables;
  if (node.is_table()) tables.push_back(node.as_table());
  if (node.is_array_of_tables())
    for (const toml::node& item : *node.as_array()) tables.push_back(item.as_table());
  for (const toml::table* table : tables) {
    const std::string name = node.is_table() ? key : fmt::format("{}[{}]", key, block.tables[key].size());
    Section inner(document(), *table, section.name(name));
    Block part{block.name + "." + name, block.kind, {}, inner.place().text()};
    read_values(part, inner, {});
    block.tables[key].push_back(std::move(part));
  }
  return !tables.empty();
}

/// Keys are those of the block and of the diagram in it: values of its parameters, and sources of its inputs.
void DiagramReader::read_nested(Block& block, Section& section) {
  const auto file = section.text("file");
  if (file) refuse_beyond_bounds(*section.node("file"), section.name("file"));
  const toml::table* table = section.table("diagram");
  if (file && table) section.wrong("diagram", "a table beside file", "one of them");
  if (!file && !table) section.missing("file", "the name of a diagram's file, or a table diagram");
  text::located(section.place(file ? "file" : "diagram"), [&] {
    const fs::path path = to_.folder / file.value_or("");
    const auto given = given_to(file ? files_.document(path).table() : *table, block, section);
    Description inner = files_.nested(section.place(), [&] {
      return file ? files_.read(files_.document(path), given)
                  : DiagramReader(root_.inner(*table, section.name("diagram")), given, files_).read();
    });
    block.diagram = std::make_shared<const Description>(std::move(inner));
  });
  std::vector<std::string> besides = {"kind", "file", "diagram"};
  for (const Parameter& parameter : block.diagram->parameters) besides.push_back(parameter.name);
  for (const std::string& name : besides) section.node(name);
  read_values(block, section, besides);
}

Given DiagramReader::given_to(const toml::table& inner, Block& block, const Section& section) const {
  Given all;
  const toml::table* parameters = inner["parameters"].as_table();
  if (!parameters) return all;
  for (const auto& [name, node] : *parameters) {
    const std::string key(name.str());
    const toml::node* given = section.table().get(key);
    if (!given) continue;
    const toml::table* own = node.as_table();
    const toml::node* const value_there = own ? own->get("value") : nullptr;
    const bool takes_text = value_there && value_there->is_string() && !text::Values::refers(*value_there);
    const Wire value = wire(*given, section.name(key));
    if (std::holds_alternative<std::string>(value) != takes_text)
      text::refuse(document().place(*given),
                   fmt::format("block '{}': {} is {}; allowed for that parameter is a {}", block.name, key,
                               text::described(*given), takes_text ? "text" : "number"));
    if (takes_text) {
      all.values[key] = std::get<std::string>(value);
      if (is_bounded(*given)) all.bounded.insert(key);
      continue;
    }
    all.values[key] = std::get<double>(value);
    refuse_other_unit(*given, own ? (*own)["unit"].value_or(std::string()) : "", section.name(key));
  }
  return all;
}

/// A parameter that is handed on to one of a diagram in a block has the unit of that one.
void DiagramReader::refuse_other_unit(const toml::node& given, const std::string& unit,
                                      const std::string& key) const {
  const auto word = given.value<std::string>();
  for (const Parameter& parameter : to_.parameters)
    if (word && *word == "$" + parameter.name && parameter.unit != unit)
      text::refuse(document().place(given),
                   fmt::format("{}: parameter '{}' is in '{}'; allowed is one in '{}'", key, parameter.name,
                               parameter.unit, unit));
}

void DiagramReader::read_limit(const std::string& name, Section& section) {
  const text::FileLimit read = text::read_limit(section);
  const toml::node* signal = section.node("signal");
  if (!signal) section.missing("signal");
  to_.limits.push_back({name, wire(*signal, section.name("signal")), read.low, read.high, read.sentence,
                        static_cast<Limit::OnLeaving>(read.on_leaving), section.place().text()});
}

void DiagramReader::read_output(const std::string& name, Section& section) {
  Output output{name, section.required_text("unit"), name, section.place().text()};
  if (const toml::node* from = section.node("from")) output.from = wire(*from, section.name("from"));
  to_.outputs.push_back(std::move(output));
}

}  // namespace tandem::engine
