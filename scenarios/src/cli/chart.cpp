// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>

#include "charts/dense_chart.hpp"
#include "charts/flat_position_chart.hpp"
#include "charts/linkage_cost_chart.hpp"
#include "charts/linkage_errors_chart.hpp"
#include "charts/mechanisms_work_chart.hpp"
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

/// The pictures of what another command left in the folder.
std::vector<charts::Picture> solvers_pictures(const Options& options) {
  check_results(options, {"solvers.csv", "solvers_conditions.json"}, "bench solvers --output {}");
  const auto caption = charts::conditions_caption(options.results / "solvers_conditions.json", 140);
  return {charts::solver_map_chart(charts::read_solver_times(options.results / "solvers.csv"), caption)};
}

std::vector<charts::Picture> dense_pictures(const Options& options) {
  check_results(options, {"dense.csv", "dense_conditions.json"}, "bench dense --output {}");
  const auto caption = charts::conditions_caption(options.results / "dense_conditions.json", 150);
  return {charts::dense_chart(charts::read_dense_times(options.results / "dense.csv"), caption)};
}

std::vector<charts::Picture> mechanisms_pictures(const Options& options) {
  check_results(options, {"work.csv", "work_conditions.json"}, "sweep mechanisms --output {}");
  const auto caption = charts::conditions_caption(options.results / "work_conditions.json", 180);
  return {
      charts::mechanisms_work_chart(charts::read_formulation_work(options.results / "work.csv"), caption)};
}

std::vector<charts::Picture> linkage_sweep_pictures(const fs::path& folder) {
  const auto caption = charts::conditions_caption(folder / "four_bar_conditions.json", 150);
  return {charts::linkage_errors_chart(charts::read_linkage_errors(folder / "four_bar.csv"), caption),
          charts::flat_position_chart(charts::read_passages(folder / "four_bar_traces.csv"), caption)};
}

std::vector<charts::Picture> linkage_bench_pictures(const fs::path& folder) {
  const auto caption = charts::conditions_caption(folder / "four_bar_conditions.json", 150);
  return {charts::linkage_cost_chart(charts::read_linkage_times(folder / "four_bar.csv"), caption)};
}

/// Of the sweep and of the benchmark, what is there: both call their table four_bar.csv, only the sweep has
/// traces.
std::string draw_four_bar(const Options& options) {
  std::vector<fs::path> folders = {options.results};
  if (options.results.empty()) folders = {"results/mbs", "results/bench"};
  std::string files;
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder / "four_bar_conditions.json")) continue;
    const bool sweep = fs::exists(folder / "four_bar_traces.csv");
    files += draw(sweep ? linkage_sweep_pictures(folder) : linkage_bench_pictures(folder),
                  {options.scene, folder, options.png});
  }
  if (files.empty())
    throw Error(
        ErrorCode::input_output,
        fmt::format("file '{}' is missing; 'tandem sweep four_bar' and 'tandem bench four_bar' write it",
                    (folders.front() / "four_bar_conditions.json").string()));
  return files;
}

struct Scene {
  const char *name, *folder;  ///< folder: where its command writes by default
  std::vector<charts::Picture> (*pictures)(const Options&);
};
const Scene scenes[] = {{"solvers", "results/bench", solvers_pictures},
                        {"dense", "results/bench", dense_pictures},
                        {"mechanisms", "results/mbs", mechanisms_pictures}};

std::string draw_scene(Options options) {
  if (options.scene == "four_bar") return draw_four_bar(options);
  for (const Scene& scene : scenes) {
    if (options.scene != scene.name) continue;
    if (options.results.empty()) options.results = scene.folder;
    return draw(scene.pictures(options), options);
  }
  throw Error(ErrorCode::internal, "no scene " + options.scene);
}

void chart(Options options, const Context& context) {
  if (options.scene == "two_mass") {
    if (options.results.empty()) options.results = "results/two_mass";
    return chart_two_mass(options, context);
  }
  const std::string files = draw_scene(options);
  if (!context.quiet) fmt::print("Charts\n{}", files);
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names = {"two_mass", "four_bar"};
  for (const Scene& scene : scenes) names.emplace_back(scene.name);
  return names;
}

}  // namespace

void add_chart(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "chart",
      "Draw the charts of a sweep or a benchmark; of two_mass print which scheme is best at which ratio");
  auto options = std::make_shared<Options>();
  command
      ->add_option("scene", options->scene,
                   "A sweep: two_mass, mechanisms; a benchmark: solvers, dense; or four_bar, which is both")
      ->required()
      ->check(CLI::IsMember(scene_names()));
  command
      ->add_option("--results", options->results,
                   "Folder of the sweep or benchmark; the charts go there too (default: where these write by "
                   "default)")
      ->type_name("DIR");
  command->add_flag("--png", options->png, "Draw PNG files too, besides SVG");
  command->footer(
      "The charts are drawn by the program gnuplot (Debian package gnuplot-nox); each leaves its script, "
      "NAME.gp.");
  command->callback([options, &context] { chart(*options, context); });
}

}  // namespace tandem::cli
