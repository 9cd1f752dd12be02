// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/read.hpp"

#include <fmt/format.h>

#include "tandem/nearest.hpp"
#include "tandem/text/section.hpp"

namespace tandem::engine {
namespace {

using text::Section;

/// Fills a Description, table by table.
class Reader {
 public:
  Reader(const text::Document& document, ParameterValues given)
      : document_(document), given_(std::move(given)) {}

  Description read() {
    Section root(document_, document_.table(), "");
    to_.name = root.text("name").value_or(document_.file());
    root.text("description");
    each(root, "parameters", [this](auto& name, Section& s) { read_parameter(name, s); });
    refuse_unknown_parameters();
    each(root, "inputs", [this](auto& name, Section& s) {
      to_.inputs.push_back({name, s.required_text("unit", "its unit, \"N\""), s.place().text()});
    });
    each(root, "blocks", [this](auto& name, Section& s) { read_block(name, s); });
    each(root, "outputs", [this](auto& name, Section& s) { read_output(name, s); });
    root.table("run");  // for whoever runs it
    root.refuse_unknown();
    if (to_.blocks.empty()) root.missing("blocks", "a table [blocks.NAME] for each block");
    return std::move(to_);
  }

 private:
  /// Calls read(name, section) for each table below a key, in the order of the file.
  template <class Read>
  void each(Section& root, const std::string& key, const Read& read) {
    const toml::table* table = root.table(key);
    if (!table) return;
    for (const auto& [name, node] : text::in_file_order(*table)) {
      if (!node->is_table())
        text::refuse(document_.place(*node),
                     key + "." + name + " is " + text::described(*node) + "; allowed is a table");
      Section section(document_, *node->as_table(), key + "." + name);
      read(name, section);
      section.refuse_unknown();
    }
  }

  void read_parameter(const std::string& name, Section& section) {
    const auto value = section.number("value");
    if (!value) section.missing("value", "a number");
    const auto it = given_.find(name);
    parameters_[name] = it == given_.end() ? *value : it->second;
    to_.parameters.push_back(
        {name, section.required_text("unit", "its unit, \"kg m^2\""), parameters_[name]});
  }

  void refuse_unknown_parameters() const {
    for (const auto& [name, value] : given_)
      if (parameters_.count(name) == 0)
        throw Error(ErrorCode::invalid_argument,
                    document_.file() + ": " + unknown("parameter", name, known()));
  }

  std::vector<std::string> known() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : parameters_) names.push_back(name);
    return names;
  }

  /// A number, "$NAME" for that of a parameter, or a text.
  Wire wire(const toml::node& node, const std::string& key) const {
    const auto text = node.value<std::string>();
    if (!node.is_string()) return text::number_of(document_, node, key);
    if (!text->starts_with("$")) return *text;
    const auto it = parameters_.find(text->substr(1));
    if (it == parameters_.end())
      text::refuse(document_.place(node), key + ": " + unknown("parameter", text->substr(1), known()));
    return it->second;
  }

  Value value(const toml::node& node, const std::string& key) const {
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

  void read_block(const std::string& name, Section& section) {
    Block block{name, section.required_text("kind", "the kind of the block"), {}, section.place().text()};
    for (const auto& [key, node] : text::in_file_order(section.table())) {
      if (key == "kind") continue;
      block.values.emplace(key, value(*section.node(key), section.name(key)));
      block.places.emplace(key, document_.place(*node).text());
    }
    to_.blocks.push_back(std::move(block));
  }

  void read_output(const std::string& name, Section& section) {
    Output output{name, section.required_text("unit", "its unit, \"rad/s\""), name, section.place().text()};
    if (const toml::node* from = section.node("from")) output.from = wire(*from, section.name("from"));
    to_.outputs.push_back(std::move(output));
  }

  const text::Document& document_;
  ParameterValues given_, parameters_;
  Description to_;
};

}  // namespace

Description read_diagram(const std::filesystem::path& file, const ParameterValues& parameters) {
  const text::Document document(file);
  return Reader(document, parameters).read();
}

Description read_diagram(const std::string& name, const std::string& text,
                         const ParameterValues& parameters) {
  const text::Document document(name, text);
  return Reader(document, parameters).read();
}

}  // namespace tandem::engine
