// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>

#include "charts/simbody_chart.hpp"
#include "charts/solver_map_chart.hpp"
#include "charts/style.hpp"
#include "charts/two_mass_best.hpp"
#include "charts/two_mass_charts.hpp"
#include "cli/commands.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string scene;
  fs::path results;
  bool png = false;
};

std::vector<charts::Picture> two_mass_pictures(const fs::path& folder,
                                               const std::vector<charts::Result>& sweep) {
  const auto caption = charts::conditions_caption(folder / "conditions.json", 165);
  const auto traces = charts::read_traces(folder / "traces.csv");
  const auto work = charts::read_work(folder / "work.csv");
  return {charts::errors_chart(sweep, caption),        charts::motion_fr90_chart(traces, caption),
          charts::energy_fr30_chart(traces, caption),  charts::motion_fr30_chart(traces, caption),
          charts::work_precision_chart(work, caption), charts::best_scheme_chart(sweep, caption)};
}

/// The folder with what another command writes.
void check_results(const Options& options, const std::vector<std::string>& names,
                   const std::string& command) {
  for (const std::string& name : names)
    if (!fs::exists(options.results / name))
      throw Error(
          ErrorCode::input_output,
          fmt::format("file '{}' is missing; 'tandem {}' writes it", (options.results / name).string(),
                      fmt::format(fmt::runtime(command), options.results.string())));
}

/// Draws them and returns their files, a line each.
std::string draw(const std::vector<charts::Picture>& pictures, const Options& options) {
  std::string files;
  for (const charts::Picture& picture : pictures) try {
      files += "  " + picture.draw(options.results, charts::Format::svg).string() + '\n';
      if (options.png) files += "  " + picture.draw(options.results, charts::Format::png).string() + '\n';
    } catch (const Error& error) {
      if (error.code() != ErrorCode::input_output) throw;
      throw RunFailed(error.what());
    }
  return files;
}

void chart_two_mass(const Options& options, const Context& context) {
  check_results(options, {"sweep.csv", "traces.csv", "work.csv", "conditions.json"},
                "sweep two_mass --output {} --resume");
  const auto sweep = charts::read_sweep(options.results / "sweep.csv");
  const auto files = draw(two_mass_pictures(options.results, sweep), options);
  if (!context.quiet) fmt::print("{}\nCharts\n{}", charts::short_table(sweep), files);
}

void chart_solvers(const Options& options, const Context& context) {
  check_results(options, {"solvers.csv", "solvers_conditions.json"}, "bench solvers --output {}");
  const auto caption = charts::conditions_caption(options.results / "solvers_conditions.json", 140);
  const auto times = charts::read_solver_times(options.results / "solvers.csv");
  const auto files = draw({charts::solver_map_chart(times, caption)}, options);
  if (!context.quiet) fmt::print("Charts\n{}", files);
}

void chart_simbody(const Options& options, const Context& context) {
  check_results(options, {"simbody.csv", "simbody_conditions.json"}, "bench simbody --output {}");
  const auto caption = charts::conditions_caption(options.results / "simbody_conditions.json", 180);
  const auto runs = charts::read_linkage_runs(options.results / "simbody.csv");
  const auto files = draw({charts::simbody_chart(runs, caption)}, options);
  if (!context.quiet) fmt::print("{}\nCharts\n{}", charts::ratios(runs), files);
}

}  // namespace

void add_chart(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "chart",
      "Draw the charts of a sweep or a benchmark; of two_mass print which scheme is best at which ratio, of "
      "simbody the times at 1 mm");
  auto options = std::make_shared<Options>();
  command->add_option("scene", options->scene, "The scene: two_mass; or a benchmark: solvers, simbody")
      ->required()
      ->check(CLI::IsMember({"two_mass", "solvers", "simbody"}));
  command
      ->add_option("--results", options->results,
                   "Folder of the sweep or benchmark; the charts go there too (default: results/SCENE; for a "
                   "benchmark results/bench)")
      ->type_name("DIR");
  command->add_flag("--png", options->png, "Draw PNG files too, besides SVG");
  command->footer(
      "The charts are drawn by the program gnuplot (Debian package gnuplot-nox); each leaves its script, "
      "NAME.gp.");
  command->callback([options, &context] {
    const bool scene = options->scene == "two_mass";
    if (options->results.empty()) options->results = fs::path("results") / (scene ? options->scene : "bench");
    if (scene) return chart_two_mass(*options, context);
    options->scene == "solvers" ? chart_solvers(*options, context) : chart_simbody(*options, context);
  });
}

}  // namespace tandem::cli
