// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "cli/adviser.hpp"
#include "cli/say.hpp"
#include "cli/study_file.hpp"
#include "cli/validators.hpp"
#include "tandem/output/files.hpp"

namespace tandem::cli {
namespace {

struct AdviseOptions {
  std::string file;
  std::vector<std::string> overrides;
  std::filesystem::path output;
  std::size_t shown = 10;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

std::string told(const advice::Choice& one) {
  return fmt::format("{:>12.3g} {:>12.10g} {:>12.10g}  {}", one.error, one.exchanges, one.own_steps,
                     words(one));
}

void tell(const Adviser& adviser, const std::string& what, const advice::Choice& choice) {
  say("{}: {}\n", what, told(choice));
  if (const auto text = adviser.reason(choice); !text.empty()) say("  {}\n", text);
}

void tell_all(const advice::Ranking& ranking, std::size_t most) {
  say("\n{:>12} {:>12} {:>12}\n", "error", "exchanges", "own steps");
  const std::size_t shown = std::min(most, ranking.choices.size());
  for (std::size_t k = 0; k < shown; ++k) say("{}\n", told(ranking.choices[k]));
  say("errors are parts of the tolerance; {} more schemes came to an error, {} to none\n\n",
      ranking.choices.size() - shown, ranking.others);
}

void advise(const AdviseOptions& options, const Context& context) {
  const auto scenario = scenario::read(options.file, options.overrides);
  const auto folder =
      options.output.empty() ? results_of(options.file) / scenario.file.stem() / "advice" : options.output;
  Adviser adviser(scenario, folder, options.threads, context);
  const auto lines = adviser.look();
  say("{}: schemes of its standing study, predicted by\n", options.file);
  for (const std::string& line : lines) say("  {}\n", line);
  for (const std::string& line : adviser.predict()) say("  {}\n", line);
  tell_all(adviser.ranking(), options.shown);
  if (!adviser.beside().empty()) {
    say("to the end, beside {}:\n", adviser.beside());
    tell_all(adviser.last(), adviser.last().choices.size());
  }
  tell(adviser, "smallest error", adviser.last().choices.front());
  if (const auto cheapest = adviser.cheapest())
    tell(adviser, "cheapest within the tolerance", *cheapest);
  else
    say("none is within the tolerance\n");
  if (const auto chosen = adviser.chosen(); !chosen.order.empty())
    tell(adviser, "with the better order", chosen);
  output::write_text(folder / "advice.toml", adviser.lines(adviser.chosen()));
  say("wrote {}\n", (folder / "advice.toml").string());
  const auto [look, predict] = adviser.seconds();
  say("it took {:.3g} s: {:.3g} s to look at the subsystems, {:.3g} s for runs\n", look + predict, look,
      predict);
}

}  // namespace

void add_advise(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "advise",
      "Predict error and cost of the schemes that a scenario may take, by linear models of its subsystems");
  auto options = std::make_shared<AdviseOptions>();
  command->add_option("scenario", options->file, "The scenario, a TOML file or a system of SSP")
      ->required()
      ->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--show", options->shown, "So many schemes, the best first (default: 10)")
      ->check(whole);
  command
      ->add_option("--output", options->output,
                   "Folder for the table of all schemes and for the lines of the best, advice.toml (default: "
                   "results/FOLDER/SCENARIO/advice)")
      ->type_name("DIR");
  command->add_option("--threads", options->threads, "Number of threads (default: all cores)")
      ->check(threads);
  command->footer("A scenario is code: the programs and libraries that it names are run with your rights.");
  command->callback([options, &context] { advise(*options, context); });
}

}  // namespace tandem::cli
