// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/coordinator/schedule.hpp"
#include "tandem/scenario/document_of.hpp"
#include "tandem/scenario/impulse_entry.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of_scenarios(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (entry.is_regular_file() && (entry.path().extension() == ".toml" || scenario::is_system(entry.path())))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// A scenario is a file with subsystems; its name and description, as far as they can be read.
void print_line_of(const fs::path& file) {
  try {
    const text::Document document = scenario::document_of(file);
    if (!document.table().contains("subsystems")) return;
    say("  {}  {}\n", file.string(), document.table()["description"].value_or(std::string()));
  } catch (const Error& error) {
    say("  {}  ({})\n", file.string(), error.what());
  }
}

void print_scenarios(const fs::path& folder, bool asked) {
  if (fs::is_directory(folder)) {
    say("scenarios in {}:\n", folder.string());
    for (const fs::path& file : files_of_scenarios(folder)) print_line_of(file);
    return;
  }
  if (asked) throw Error(ErrorCode::input_output, "folder '" + folder.string() + "' is not there");
  say("scenarios: there is no folder '{}' here; name another one\n", folder.string());
}

void print_words(const Context& context) {
  say("sources:\n");
  for (const auto& [name, source] : context.builtins.models)
    if (name != scenario::impulse_model) say("  builtin:{}\n", name);
  for (const auto& [scheme, source] : context.builtins.schemes)
    say("  {}:{}\n", scheme, source.elsewhere ? "..." : "FILE");
  say("schedules:");
  for (const auto kind : {Schedule::Kind::slowest_first, Schedule::Kind::fastest_first,
                          Schedule::Kind::staggered, Schedule::Kind::parallel})
    say(" {}", Schedule::name(kind));
  say("\nreconstructions: {} least_squaresD_EXTRA (degree D 0 to 4, EXTRA 1 to 16 samples)\n",
      fmt::join(Reconstruction::words(), " "));
}

}  // namespace

void add_list(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "list", "List the sources that are built in, scenarios, schedules and reconstructions");
  auto folder = std::make_shared<std::string>("scenarios");
  auto* option = command->add_option("folder", *folder, "Where to look for scenarios, with its subfolders")
                     ->type_name("DIR")
                     ->capture_default_str();
  command->callback([folder, option, &context] {
    print_words(context);
    print_scenarios(*folder, option->count() > 0);
  });
}

}  // namespace tandem::cli
