// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "ladder/ladder_run.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"
#include "tandem/output/progress.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct LadderOptions {
  fs::path file, output;
  std::vector<std::string> overrides;
  int repetitions = 3;
};

/// All rungs once for their results, then in turns for their times, of which the least counts.
std::vector<scenario::RungRun> run_rungs(scenario::Ladder& ladder, const fs::path& folder, int repetitions,
                                         bool shown) {
  const InterruptGuard guard;
  const auto going = [] { return !InterruptGuard::interrupted(); };
  output::Progress progress("ladder", ladder.size() * static_cast<std::size_t>(1 + repetitions), shown);
  std::vector<scenario::RungRun> runs;
  std::size_t done = 0;
  try {
    for (std::size_t k = 0; k < ladder.size(); ++k, progress.update(++done))
      runs.push_back(ladder.run(k, folder, going));
    for (int turn = 0; turn < repetitions; ++turn)
      for (std::size_t k = 0; k < ladder.size(); ++k, progress.update(++done))
        if (scenario::RungRun& run = runs[k]; run.failure.empty()) {
          const double seconds = ladder.seconds(k, going);
          run.seconds = turn == 0 ? seconds : std::min(run.seconds, seconds);
        }
  } catch (const Error& error) {
    if (going()) throw;
    throw RunFailed("interrupted; nothing more is written");
  }
  return runs;
}

void climb(const LadderOptions& options, const Context& context) {
  auto of_scene = options.overrides;
  std::erase_if(of_scene, [](const std::string& one) { return !one.starts_with("ladder."); });
  const auto scene = scenario::read(options.file, of_scene);
  scenario::Ladder ladder(scene, scenario::overrides_of_rungs(options.overrides), context.builtins);
  const fs::path folder =
      options.output.empty() ? fs::path("results") / "ladder" / options.file.stem() : options.output;
  ladder.check_folder(folder);
  const KeptFolder kept(folder);
  for (const char* of_before : {"ladder.csv", "verdict.txt", "ladder.json", "ladder.svg"})
    fs::remove(folder / of_before);
  const auto runs = run_rungs(ladder, folder, options.repetitions, !context.quiet);
  if (const scenario::RungRun& richest = runs.back(); !richest.failure.empty())
    throw RunFailed("the richest rung '" + richest.name + "' failed: " + richest.failure);
  const auto columns = ladder.columns(runs);
  output::write_text(folder / "ladder.csv",
                     std::string(scenario::ladder_header) + "\n" + scenario::ladder_rows(runs, columns));
  const std::string text = scenario::ladder_text(runs, columns);
  output::write_text(folder / "verdict.txt", text);
  const nlohmann::ordered_json about = {
      {"reference", "the richest, " + runs.back().name},
      {"norms", {{"seconds", fmt::format("processor time, the least of {} in turns", options.repetitions)}}},
      {"made", output::made()}};
  output::write_text(folder / "ladder.json", about.dump(2) + "\n");
  say("{}", text);
  if (!context.quiet) say("wrote {}\n", (folder / "ladder.csv").string());
}

}  // namespace

void add_ladder(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "ladder", "Run the models of a scene from simple to rich, and tell the simplest that is good enough");
  auto options = std::make_shared<LadderOptions>();
  command->add_option("scenario", options->file, "A scenario with a table [ladder], a TOML file")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--set", options->overrides,
                   "Set a value of each rung, or ladder.KEY, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--output", options->output, "Folder of the results (default: results/ladder/NAME)")
      ->type_name("DIR");
  command
      ->add_option("--repetitions", options->repetitions,
                   "Runs of each rung for its processor time; 0: none is taken")
      ->check(from_to(0, 1000))
      ->capture_default_str();
  command->footer(
      "Writes ladder.csv, verdict.txt, ladder.json and NAME/results.csv of each rung; `tandem chart "
      "ladder --results DIR`\n"
      "draws differences against processor time. docs/ladder.md tells of the table [ladder].\n"
      "A scenario is code: the programs and libraries that its rungs name are run with your rights.\n"
      "Exit status: 0; 1 if it was interrupted, or if the richest rung fails; 2 for bad input.");
  command->callback([options, &context] { climb(*options, context); });
}

}  // namespace tandem::cli
