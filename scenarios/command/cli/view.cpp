// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "tandem/error.hpp"
#include "tandem/output/files.hpp"
#include "tandem/scenario/about.hpp"
#include "view/data.hpp"
#include "view/page.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  fs::path results, with, output;
  int every = 0;
  bool plots_only = false;
};

constexpr double large = 50e6;  ///< bytes from which a page is told to be slow to open

view::Run read(const fs::path& place, bool plots_only) {
  if (const std::string what = scenario::unfinished(place); !what.empty()) spdlog::warn("note: {}", what);
  view::Run run = view::read_run(place);
  if (plots_only) return run;
  view::read_mechanisms(run);
  view::check_positions(run);
  return run;
}

void add_note_of_rows(std::vector<std::string>& notes, const text::TimeTable& table, int every) {
  const view::Thinning thinning = view::thinning_of(table, every);
  const std::string file = table.file.filename().string();
  const std::size_t rows = table.times.size();
  if (thinning.most_in_band() > 1)
    notes.push_back(
        fmt::format("{} has {} rows, too many for a page: of each {} the smallest and the largest value are "
                    "drawn, and positions of the first and the last; --every 1 keeps every row.",
                    file, rows, thinning.most_in_band()));
  else if (every > 1)
    notes.push_back(
        fmt::format("One of each {} rows of {} is shown, {} of {}.", every, file, thinning.rows(), rows));
}

/// What is not as one might expect it.
std::vector<std::string> notes(const view::Content& content, const ViewOptions& options) {
  std::vector<std::string> all;
  if (options.plots_only)
    all.emplace_back("Plots only, as --plots-only was said.");
  else if (std::all_of(content.runs.begin(), content.runs.end(),
                       [](const view::Run& run) { return run.mechanisms.empty(); }))
    all.emplace_back("No subsystem of this run is a mechanism from a file: there are plots only.");
  for (const view::Run& run : content.runs)
    for (const auto& table : run.tables) add_note_of_rows(all, table, content.every);
  return all;
}

/// Beside the results, if it is not said where.
fs::path output_of(const ViewOptions& options) {
  if (!options.output.empty()) return options.output;
  if (fs::is_directory(options.results)) return options.results / "view.html";
  fs::path beside = options.results;
  return beside.replace_extension(".html");
}

void view_results(const ViewOptions& options, const Context& context) {
  view::check_page();
  view::Content content{{}, options.every, {}};
  content.runs.push_back(read(options.results, options.plots_only));
  if (!options.with.empty()) content.runs.push_back(read(options.with, options.plots_only));
  content.notes = notes(content, options);
  for (const std::string& note : content.notes) spdlog::info("note: {}", note);
  const std::string page = view::page(view::data_of(content));
  const fs::path file = output_of(options);
  output::replace_text(file, page);
  if (static_cast<double>(page.size()) > large)
    spdlog::info("note: the page has {:.0f} MB and opens slowly; a larger N of --every makes it smaller",
                 1e-6 * static_cast<double>(page.size()));
  if (!context.quiet) say("wrote {}\n", file.string());
}

}  // namespace

void add_view(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "view", "Write a page (HTML, one file) that shows results: the mechanisms moving, and plots");
  auto options = std::make_shared<ViewOptions>();
  command->add_option("results", options->results, "The folder of a run, or a CSV file")
      ->required()
      ->type_name("RESULTS");
  command->add_option("--with", options->with, "Results to lay them over, a reference for instance")
      ->type_name("RESULTS");
  command->add_option("--output", options->output, "The page (default: view.html in the folder)")
      ->type_name("FILE");
  command
      ->add_option("--every", options->every,
                   "Keep one of each N rows, 1 all of them (default: all, and of too many the smallest and "
                   "largest values)")
      ->check(positive)
      ->type_name("N");
  command->add_flag("--plots-only", options->plots_only, "Leave the mechanisms out");
  command->footer(
      "A mechanism that runs alone records where its points are; in a scenario record.animate = true does "
      "it:\n"
      "  tandem run SCENARIO --set record.animate=true\n"
      "The page needs no network and no other file.");
  command->callback([options, &context] { view_results(*options, context); });
}

}  // namespace tandem::cli
