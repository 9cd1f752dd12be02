// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/file_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/nearest.hpp"

namespace tandem::text {
namespace {

/// What is given must be of the type that stands in the file.
FileValue given_or(const std::string& name, FileValue value, const GivenValues& given,
                   const Section& section) {
  const auto it = given.find(name);
  if (it == given.end()) return value;
  if (it->second.index() == value.index()) return it->second;
  refuse(section.place(), fmt::format("parameter '{}' is {}; allowed is {}", name,
                                      value.index() == 0 ? "given as a text" : "given as a number",
                                      value.index() == 0 ? "a number" : "a text"));
}

void read_word(FileParameter& parameter, const GivenValues& given, Section& section) {
  const std::string own = *section.text("value");
  parameter.value = given_or(parameter.name, own, given, section);
  const auto words = section.texts("allowed");
  const auto& word = std::get<std::string>(parameter.value);
  const bool is_listed = std::find(words.begin(), words.end(), word) != words.end();
  if (!words.empty() && !is_listed)
    refuse(section.place(),
           fmt::format("parameter '{}' is '{}'; allowed is {}", parameter.name, word, listed(words)));
  parameter.allowed_word = is_listed || word == own;
}

FileParameter read_parameter(const std::string& name, const GivenValues& given, Section& section) {
  FileParameter parameter{name, "", 0.0, section.place()};
  const toml::node* value = section.node("value");
  if (!value) section.missing("value", "a number or a text");
  if (value->is_string() && !Values::refers(*value)) {
    read_word(parameter, given, section);
  } else {
    parameter.value = given_or(name, *section.number("value"), given, section);
    parameter.unit = section.required_text("unit", "its unit, \"kg m^2\"");
  }
  section.refuse_unknown();
  return parameter;
}

}  // namespace

std::vector<FileParameter> read_parameters(Section& root, const GivenValues& given, Values& values) {
  std::vector<FileParameter> all;
  if (const toml::table* table = root.table("parameters"))
    for (const auto& [name, node] : in_file_order(*table)) {
      const std::string path = root.name("parameters." + name);
      if (!node->is_table())
        refuse(root.document().place(*node), path + " is " + described(*node) + "; allowed is a table");
      Section section(root.document(), *node->as_table(), path, &values);
      all.push_back(read_parameter(name, given, section));
      values.set(name, all.back().value);
    }
  std::vector<std::string> known;
  for (const FileParameter& parameter : all) known.push_back(parameter.name);
  for (const auto& [name, value] : given)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorCode::invalid_argument,
                  root.document().file() + ": " + unknown("parameter", name, known));
  return all;
}

GivenValues given_values(const Document& document,
                         const std::function<std::optional<FileValue>(const FileParameter&)>& find) {
  GivenValues given;
  Values own;
  Section root(document, document.table(), "");
  for (const FileParameter& parameter : read_parameters(root, {}, own))
    if (const auto value = find(parameter)) given[parameter.name] = *value;
  return given;
}

}  // namespace tandem::text
