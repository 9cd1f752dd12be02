// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "languages/languages.hpp"
#include "languages/schema.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/keys.hpp"

namespace tandem::cli {
namespace {

using text::Key;
using text::Keys;

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, keys] : scenario::languages()) all.push_back(name);
  return all;
}

std::string kind_of(const Key& key) {
  return key.kinds.empty() ? "" : fmt::format(" of kind {}", fmt::join(key.kinds, ", "));
}

void print(const std::string& language, const Keys& keys, const Key& key) {
  say("{}{} ({})\n  {}\n  value: {}\n", key.path, kind_of(key), language, key.sentence, text::described(key));
  if (key.required)
    say("  it is required\n");
  else if (!key.otherwise.empty())
    say("  where it is not there: {}\n", key.otherwise);
  std::vector<std::string> inner;
  for (const Key* one : keys.in(key.path, key.kinds.empty() ? "" : key.kinds[0]))
    inner.push_back(text::name_of(*one));
  if (!inner.empty()) say("  keys: {}\n", fmt::join(inner, ", "));
}

/// "connections[fast.x2].gain" of --set is "connections.gain".
std::string without_brackets(std::string key) {
  for (auto open = key.find('['); open != std::string::npos; open = key.find('[')) {
    const auto close = key.find(']', open);
    key.erase(open, close == std::string::npos ? close : close - open + 1);
  }
  return key;
}

/// Of a name alone, in whatever table.
bool print_all_called(const std::string& name) {
  bool found = false;
  for (const auto& [language, keys] : scenario::languages())
    for (const Key& key : keys.all())
      if (text::name_of(key) == name) print(language, keys, key), found = true;
  return found;
}

[[noreturn]] void refuse(const std::string& asked) {
  std::vector<std::string> all = names();
  for (const auto& [language, keys] : scenario::languages())
    for (const Key& key : keys.all()) all.push_back(text::name_of(key));
  const std::string near = nearest(asked, all);
  throw Error(
      ErrorCode::invalid_argument,
      fmt::format("no language has a key '{}'{}; tandem help LANGUAGE lists the keys of {}", asked,
                  near.empty() ? "" : fmt::format("; did you mean '{}'?", near), fmt::join(names(), ", ")));
}

/// A language, or a key of any of them.
void help(const std::string& words) {
  const std::string asked = without_brackets(words);
  if (const auto language = scenario::languages().find(asked); language != scenario::languages().end())
    return say("{}", language->second.page());
  bool found = false;
  for (const auto& [name, keys] : scenario::languages())
    for (const Key* key : keys.matching(asked)) {
      print(name, keys, *key);
      found = true;
    }
  if (found || print_all_called(asked)) return;
  const std::string table = asked.substr(0, asked.find_first_of(".["));
  for (const auto& [name, keys] : scenario::languages())
    if (!keys.matching(table).empty()) keys.refuse(asked);
  refuse(asked);
}

void print_schema(const std::string& language) {
  say("{}\n", scenario::schema(scenario::languages().at(language), "tandem " + language).dump(2));
}

}  // namespace

void add_help(CLI::App& app, Context&) {
  auto* command = app.add_subcommand(
      "help", "Tell what a key of a scenario, mechanism, diagram or study means, or all of them");
  auto asked = std::make_shared<std::string>();
  command
      ->add_option(
          "key", *asked,
          fmt::format("A key, like coordination.order, connections.gain or elements.drag.along; or {}, "
                      "for the page of all",
                      fmt::join(names(), " or ")))
      ->required();
  command->callback([asked] { help(*asked); });
}

void add_schema(CLI::App& app, Context&) {
  auto* command = app.add_subcommand("schema", "Print the JSON schema of a language, for editors");
  auto language = std::make_shared<std::string>();
  command->add_option("language", *language, fmt::format("Which: {}", fmt::join(names(), ", ")))
      ->required()
      ->check(one_of(names()));
  command->callback([language] { print_schema(*language); });
}

}  // namespace tandem::cli
