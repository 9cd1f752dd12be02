// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/text/section.hpp"
#include "tandem/text/set.hpp"

namespace tandem::scenario {
namespace {

class ParameterReader {
 public:
  ParameterReader(const text::Document& document, const text::Values* constants)
      : document_(document), constants_(constants) {}

  /// quoted: the key within the table.
  void read(const std::string& key, const toml::node& node, const std::string& path,
            const std::string& quoted) {
    const text::Place place = document_.place(node);
    if (is_reference(node))
      add({key, referred(node, path), place, true, quoted});
    else if (node.is_number())
      add({key, number(node, path), place, false, quoted});
    else if (const auto* text = node.as_string())
      add({key, word(*text), place, false, quoted});
    else if (const auto* flag = node.as_boolean())
      add({key, flag->get(), place, false, quoted});
    else if (const auto* table = node.as_table(); table && !table->empty())
      for (const auto& [name, inner] : text::in_file_order(*table))
        read(key + "." + name, *inner, path + "." + name, quoted + "." + text::toml_text(name));
    else if (const auto* list = node.as_array())
      read_list(key, *list, path);
    else
      text::refuse(place, path + " is " + text::described(node) +
                              "; allowed is a number, true, false, a text, a list or a table of these");
  }

  std::vector<Parameter> all;

 private:
  void add(Parameter one) {
    if (std::any_of(all.begin(), all.end(), [&](const Parameter& other) { return other.name == one.name; }))
      text::refuse(one.place, fmt::format("parameter '{}' is given twice; allowed is once", one.name));
    all.push_back(std::move(one));
  }
  std::string word(const toml::value<std::string>& text) const {
    return constants_ ? text::Values::literal(text.get()) : text.get();
  }
  bool is_reference(const toml::node& node) const { return constants_ && text::Values::refers(node); }
  Parameters::Value referred(const toml::node& node, const std::string& path) const {
    const text::FileValue found = constants_->value(document_, node, path);
    if (const auto* number = std::get_if<double>(&found)) return *number;
    return std::get<std::string>(found);
  }
  double number(const toml::node& node, const std::string& path) const {
    return constants_ ? constants_->number(document_, node, path) : text::number_of(document_, node, path);
  }

  void read_list(const std::string& key, const toml::array& list, const std::string& path) {
    std::string numbers;
    for (const toml::node& node : list)
      if (const auto* name = node.as_string(); name && !is_reference(node))
        add({key + "." + name->get(), true, document_.place(node)});
      else
        numbers += fmt::format("{}{}", numbers.empty() ? "" : " ", number(node, path));
    if (list.empty())
      text::refuse(document_.place(list), path + " is an empty list; allowed is one with names or numbers");
    if (!numbers.empty()) add({key, numbers, document_.place(list)});
  }

  const text::Document& document_;
  const text::Values* constants_;
};

}  // namespace

std::vector<Parameter> read_parameters(const text::Document& document, const toml::table& table,
                                       const std::string& path, const text::Values* constants,
                                       const std::string& but) {
  ParameterReader reader(document, constants);
  for (const auto& [key, node] : text::in_file_order(table))
    if (key != but) reader.read(key, *node, path + "." + key, text::toml_text(key));
  return std::move(reader.all);
}

}  // namespace tandem::scenario
