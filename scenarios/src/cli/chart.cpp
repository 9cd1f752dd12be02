// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/chart_scenes.hpp"
#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct ChartOptions {
  std::string scene;
  fs::path results;
  bool png = false;
};

void check_results(const ChartScene& scene, const fs::path& folder) {
  for (const char* name : scene.files)
    if (!fs::exists(folder / name))
      throw Error(ErrorCode::input_output,
                  fmt::format("file '{}' is missing; 'tandem {}' writes it", (folder / name).string(),
                              fmt::format(fmt::runtime(scene.command), folder.string())));
}

/// Draws them and returns their files, a line each.
std::string draw(const std::vector<charts::Picture>& pictures, const fs::path& folder, bool png) {
  std::string files;
  for (const charts::Picture& picture : pictures) try {
      files += "  " + picture.draw(folder, charts::Format::svg).string() + '\n';
      if (png) files += "  " + picture.draw(folder, charts::Format::png).string() + '\n';
    } catch (const Error& error) {
      if (error.code() != ErrorCode::input_output) throw;
      throw RunFailed(error.what());
    }
  return files;
}

void chart(const ChartOptions& options, const Context& context) {
  const auto scenes = chart_scenes();
  const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const ChartScene& s) { return options.scene == s.name; });
  const fs::path folder = options.results.empty() ? fs::path(scene->folder) : options.results;
  check_results(*scene, folder);
  const Drawing drawing = scene->draw(folder);
  const std::string files = draw(drawing.pictures, folder, options.png);
  if (context.quiet) return;
  if (!drawing.table.empty()) say("{}\n", drawing.table);
  say("Charts\n{}", files);
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const ChartScene& scene : chart_scenes()) names.emplace_back(scene.name);
  return names;
}

}  // namespace

void add_chart(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "chart",
      "Draw the charts of a sweep or a benchmark; of two_mass print which scheme is best at which ratio, of "
      "simbody the times at 1 mm");
  auto options = std::make_shared<ChartOptions>();
  command
      ->add_option("scene", options->scene,
                   "A sweep: two_mass, split_pendulum, engine, engine_linkage, kart, mechanisms, four_bar; a "
                   "ladder; or a benchmark: four_bar_cost (of bench four_bar), engine_linkage_elsewhere (of "
                   "bench engine_linkage), solvers, dense, threads, transports, simbody")
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
