// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/file_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/nearest.hpp"

namespace tandem::text {
namespace {

/// What is given must be of the type that stands in the file. Whoever gave it knows the place.
FileValue given_or(const std::string& name, FileValue value, const GivenValues& given) {
  const auto it = given.find(name);
  if (it == given.end()) return value;
  if (it->second.index() == value.index()) return it->second;
  const auto* const number = std::get_if<double>(&it->second);
  throw Error(ErrorCode::invalid_argument,
              number ? fmt::format("parameter '{}' is {}; allowed is a text", name, *number)
                     : fmt::format("parameter '{}' is '{}'; allowed is a number", name,
                                   std::get<std::string>(it->second)));
}

void read_word(FileParameter& parameter, const GivenValues& given, Section& section) {
  const std::string own = *section.text("value");
  parameter.value = given_or(parameter.name, own, given);
  const auto& words = parameter.allowed = section.texts("allowed");
  const auto& word = std::get<std::string>(parameter.value);
  const bool is_listed = std::find(words.begin(), words.end(), word) != words.end();
  if (!words.empty() && !is_listed) {
    const std::string sentence =
        fmt::format("parameter '{}' is '{}'; allowed is {}", parameter.name, word, listed(words));
    if (given.contains(parameter.name)) throw Error(ErrorCode::invalid_argument, sentence);
    refuse(section.place(), sentence);
  }
  parameter.allowed_word = is_listed || word == own;
}

FileParameter read_parameter(const std::string& name, const GivenValues& given, Section& section) {
  FileParameter parameter{name, "", 0.0, section.place()};
  const toml::node* value = section.node("value");
  if (!value) section.missing("value");
  if (value->is_string() && !Values::refers(*value)) {
    if (section.node("unit")) section.wrong("value", described(*value), "a number, as it has a unit");
    read_word(parameter, given, section);
  } else {
    section.leave_out("allowed", "a number has no list of words");
    parameter.value = given_or(name, *section.number("value"), given);
    if (!section.node("unit")) section.missing("unit");
    parameter.unit = *section.text("unit");
  }
  section.refuse_unknown();
  return parameter;
}

}  // namespace

void keys_of_parameters(KeyList& to) {
  using enum Key::Type;
  to.named("parameters", "Numbers and words that others may set.", "One of them; `$NAME` stands for it.")
      .need("value", name, "What it is unless somebody else gives it.")
      .may("unit", text, "Of a number: its unit, which it has to have.", {.allowed = "like \"kg m^2\""})
      .may("allowed", texts, "Of a word: the words that it may be; without it any.");
}

std::vector<FileParameter> read_parameters(Section& root, const GivenValues& given, Values& values) {
  std::vector<FileParameter> all;
  if (auto table = root.section("parameters"))
    for (auto& [name, section] : table->with(values).named_sections()) {
      if (is_reserved(name))
        refuse(section.place(),
               "parameter '" + name + "' has a name that expressions have already; allowed is another");
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

std::vector<FileParameter> parameters_of(const Document& document, const GivenValues& given) {
  static const Keys language = [] {
    KeyList list;
    keys_of_parameters(list);
    return Keys(std::move(list).list());
  }();
  Values own;
  Section root(document, language);
  return read_parameters(root, given, own);
}

static Values values_of(const Document& document, const GivenValues& given) {
  Values own;
  for (const FileParameter& parameter : parameters_of(document, given))
    own.set(parameter.name, parameter.value);
  return own;
}

bool is_of_run(const std::string& name) { return name == "start" || name == "stop" || name == "inputs"; }

/// What [run] says of a parameter.
static const toml::node* node_in_run(const Document& document, const std::string& name) {
  return is_of_run(name) ? nullptr : document.table()["run"][name].node();
}

/// What [run] says of a parameter, if the file allows it.
static void give(GivenValues& given, const Document& document, const FileParameter& p, const toml::node& node,
                 FileValue value) {
  given[p.name] = std::move(value);
  located(document.place(node), [&] { parameters_of(document, given); });
}

Values values_in_run(const Document& document,
                     const std::function<std::optional<FileValue>(const FileParameter&)>& find) {
  GivenValues given;
  std::vector<std::pair<FileParameter, const toml::node*>> references;
  for (const FileParameter& p : parameters_of(document, {})) {
    const toml::node* const node = node_in_run(document, p.name);
    if (const auto found = find(p))
      given[p.name] = *found;
    else if (node && Values::refers(*node))
      references.emplace_back(p, node);
    else if (node && node->is_number())
      give(given, document, p, *node, *node->value<double>());
    else if (node && node->is_string())
      give(given, document, p, *node, Values::literal(*node->value<std::string>()));
  }
  for (const auto& [p, node] : references)
    give(given, document, p, *node, values_of(document, given).value(document, *node, "run." + p.name));
  return values_of(document, given);
}

GivenValues given_values(const Document& document,
                         const std::function<std::optional<FileValue>(const FileParameter&)>& find) {
  GivenValues given;
  for (const FileParameter& parameter : parameters_of(document, {}))
    if (const auto value = find(parameter)) given[parameter.name] = *value;
  return given;
}

}  // namespace tandem::text
