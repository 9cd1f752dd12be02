// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "cli/say.hpp"
#include "cli/study_file.hpp"
#include "cli/sweep_study.hpp"
#include "tandem/advice/advice.hpp"
#include "tandem/advice/leading.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/output/files.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/study/standing.hpp"

namespace tandem::cli {
namespace {

struct AdviseOptions {
  std::string file;
  std::vector<std::string> overrides;
  std::filesystem::path output;
  std::size_t shown = 10;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

/// What is continuous and runs itself costs a run for each scheme.
bool runs_itself(const identification::Stand& stand) { return !stand.is_known(); }

void tell_stands(const std::vector<identification::Stand>& stands) {
  for (const identification::Stand& one : stands)
    if (one.modelled)
      say("  {}: a linear model of order {}, which leaves {:.2g} of its responses\n", one.source, one.order,
          one.residual);
    else
      say("  {}: runs itself; {}\n", one.source, one.why);
}

std::string told(const advice::Choice& one) {
  return fmt::format("{:>12.3g} {:>12.10g} {:>12.10g}  {}, {}, steps x {}", one.error, one.exchanges,
                     one.own_steps, one.schedule, one.reconstruction, one.steps);
}

class Adviser {
 public:
  Adviser(const AdviseOptions& options, const Context& context)
      : options_(options),
        builtins_(without_matrices(context.builtins)),
        scenario_(scenario::read(options.file, options.overrides)),
        folder_(options.output.empty() ? results_of(options.file) / scenario_.file.stem() / "advice"
                                       : options.output),
        advised_(context),
        overrides_(options.overrides) {
    advised_.builtins = models_.replacing(builtins_);
    advised_.quiet = true;
  }

  void advise() {
    scenario::Assembly assembly(scenario_, advised_.builtins);
    assembly.initialize();  // finds the models
    const auto stands = models_.stands();
    say("{}: schemes of its standing study, predicted by\n", scenario_.file.string());
    tell_stands(stands);
    for (const std::string& line : advice::on_leading(assembly.coordinator())) say("  {}\n", line);
    if (std::any_of(stands.begin(), stands.end(), runs_itself)) shorten();
    sweep_study({options_.file,
                 folder_,
                 overrides_,
                 {},
                 "",
                 options_.threads,
                 false,
                 false,
                 study::standing_study(scenario_, builtins_)},
                advised_);
    tell(advice::ranking(folder_ / "schemes.csv"));
  }

 private:
  /// Of runs of the subsystems themselves the first part has to do.
  void shorten() {
    constexpr double part = 0.15;
    const double stop = scenario_.start + part * (scenario_.stop - scenario_.start);
    overrides_.push_back(fmt::format("span.stop={:.17g}", stop));
    say("  so each scheme runs to {:.6g} s only, and errors are those of that time\n", stop);
  }

  void tell(const advice::Ranking& ranking) const {
    if (ranking.choices.empty())
      throw RunFailed("no scheme came to an error; " + (folder_ / "schemes.csv").string() + " tells why");
    say("\n{:>12} {:>12} {:>12}\n", "error", "exchanges", "own steps");
    for (std::size_t k = 0; k < std::min(options_.shown, ranking.choices.size()); ++k)
      say("{}\n", told(ranking.choices[k]));
    say("errors are parts of the tolerance; {} more schemes came to an error, {} to none\n",
        ranking.choices.size() - std::min(options_.shown, ranking.choices.size()), ranking.others);
    say("\nsmallest error: {}\n", told(ranking.choices.front()));
    tell_reason(ranking.choices.front());
    const auto cheapest = ranking.cheapest();
    if (cheapest)
      say("cheapest within the tolerance: {}\n", told(*cheapest)), tell_reason(*cheapest);
    else
      say("none is within the tolerance\n");
    const auto file = folder_ / "advice.toml";
    output::write_text(file, advice::lines(cheapest ? *cheapest : ranking.choices.front(), scenario_,
                                           options_.overrides, builtins_));
    say("wrote {}\n", file.string());
  }

  void tell_reason(const advice::Choice& choice) const {
    const auto text =
        advice::reason(advice::chosen(choice, scenario_, options_.overrides, builtins_), builtins_);
    if (!text.empty()) say("  {}\n", text);
  }

  const AdviseOptions& options_;
  Builtins builtins_;
  scenario::Scenario scenario_;
  std::filesystem::path folder_;
  identification::Models models_;
  Context advised_;
  std::vector<std::string> overrides_;
};

}  // namespace

void add_advise(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "advise",
      "Predict error and cost of the schemes that a scenario may take, by linear models of its subsystems");
  auto options = std::make_shared<AdviseOptions>();
  command->add_option("scenario", options->file, "The scenario, a TOML file")->required()->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--show", options->shown, "So many schemes, the best first (default: 10)");
  command
      ->add_option("--output", options->output,
                   "Folder for the table of all schemes and for the lines of the best, advice.toml (default: "
                   "results/FOLDER/SCENARIO/advice)")
      ->type_name("DIR");
  command->add_option("--threads", options->threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1U, 1024U));
  command->footer("A scenario is code: the programs and libraries that it names are run with your rights.");
  command->callback([options, &context] { Adviser(*options, context).advise(); });
}

}  // namespace tandem::cli
