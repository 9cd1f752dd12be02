// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "scenario/keys.hpp"
#include "scenario/schema.hpp"

namespace tandem::cli {
namespace {

const std::map<std::string, const text::Keys*>& languages() {
  static const std::map<std::string, const text::Keys*> all = {{"scenario", &scenario::keys()}};
  return all;
}

void print(const text::Key& key) {
  say("{}\n  {}\n  value: {}\n", key.path, key.sentence, text::described(key));
  if (key.required)
    say("  it is required\n");
  else if (!key.otherwise.empty())
    say("  where it is not there: {}\n", key.otherwise);
}

/// A language, or a key of one.
void help(const std::string& asked) {
  if (const auto language = languages().find(asked); language != languages().end())
    return say("{}", language->second->page());
  print(scenario::keys().named(asked));
}

void print_schema(const std::string& language) {
  say("{}\n", scenario::schema(*languages().at(language), "tandem " + language).dump(2));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, keys] : languages()) all.push_back(name);
  return all;
}

}  // namespace

void add_help(CLI::App& app, Context&) {
  auto* command = app.add_subcommand("help", "Tell what a key of a scenario means, or all of them");
  auto asked = std::make_shared<std::string>();
  command
      ->add_option("key", *asked,
                   "A key, like coordination.order or connections.gain; or scenario, for the page of all")
      ->required();
  command->callback([asked] { help(*asked); });
}

void add_schema(CLI::App& app, Context&) {
  auto* command = app.add_subcommand("schema", "Print the JSON schema of a language, for editors");
  auto language = std::make_shared<std::string>();
  command->add_option("language", *language, "Which: scenario")->required()->check(CLI::IsMember(names()));
  command->callback([language] { print_schema(*language); });
}

}  // namespace tandem::cli
