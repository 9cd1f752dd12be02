// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/chart_file.hpp"
#include "cli/chart_results.hpp"
#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "cli/study_file.hpp"
#include "tandem/charts/draw.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output/files.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct ChartOptions {
  std::vector<std::string> what;
  std::vector<std::string> plotted, names;
  std::string where;
  fs::path results;
  bool png = false;
};

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

/// Leaves out the charts that are not asked for.
void keep_named(charts::Charts& charts, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const charts::Chart& chart : charts.all) known.push_back(chart.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorCode::invalid_argument, unknown("chart", name, known));
  if (!names.empty())
    std::erase_if(charts.all, [&](const charts::Chart& chart) {
      return std::find(names.begin(), names.end(), chart.name) == names.end();
    });
}

/// The charts draw no rows but these, besides what each says itself.
void keep_rows(charts::Charts& charts, const std::string& where) {
  if (where.empty()) return;
  for (charts::Chart& chart : charts.all) {
    const std::string own = chart.where ? "(" + chart.where->text + ") && " : "";
    chart.where = charts::Quantity{own + "(" + where + ")", {"--where", 0}};
  }
}

ChartFile charts_of(const std::string& name, const Builtins& builtins) {
  if (const fs::path file = study_path(name); name.ends_with(".toml") || fs::exists(file))
    return read_chart_file(file, builtins);
  if (name == "ladder") return charts_of_ladder();
  throw Error(ErrorCode::invalid_argument,
              "there are no charts of '" + name +
                  "'; allowed are a file, NAME of scenarios/NAME/study.toml, and ladder");
}

charts::Drawing of_file(const ChartOptions& options, const Builtins& builtins, fs::path& folder) {
  ChartFile file = charts_of(options.what[0], builtins);
  keep_named(file.charts, options.names);
  keep_rows(file.charts, options.where);
  if (folder.empty()) folder = file.results;
  if (folder.empty())
    throw Error(ErrorCode::invalid_argument, "--results is missing: the folder that tandem ladder wrote");
  return charts::draw(file.charts, folder, file.only_table);
}

charts::Drawing of_results(const ChartOptions& options, fs::path& folder) {
  const fs::path first = options.what[0];
  if (folder.empty()) folder = fs::is_directory(first) ? first : fs::absolute(first).parent_path();
  return plotted({options.what.begin(), options.what.end()}, options.plotted, folder);
}

charts::Drawing drawn(const ChartOptions& options, const Builtins& builtins, fs::path& folder) {
  if (!options.plotted.empty()) return of_results(options, folder);
  if (options.what.size() > 1)
    throw Error(ErrorCode::invalid_argument,
                "several results are given; allowed is that with --plot, which names their columns");
  return of_file(options, builtins, folder);
}

void chart(const ChartOptions& options, const Context& context) {
  fs::path folder = options.results;
  const auto drawing = drawn(options, context.builtins, folder);
  std::string files = draw(drawing.pictures, folder, options.png);
  for (const charts::Sheet& sheet : drawing.sheets) {
    output::write_text(folder / sheet.name, sheet.text);
    files += "  " + (folder / sheet.name).string() + '\n';
  }
  if (context.quiet) return;
  if (!drawing.words.empty()) say("{}\n", drawing.words);
  say("Charts\n{}", files);
}

}  // namespace

void add_chart(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("chart", "Draw the charts of a study; print what is best in maps");
  auto options = std::make_shared<ChartOptions>();
  command
      ->add_option("what", options->what,
                   "A study or a file of charts, FILE.toml, or NAME of scenarios/NAME/study.toml; ladder; or "
                   "with --plot results of runs, folders or files")
      ->required();
  command
      ->add_option("--plot", options->plotted,
                   "Columns of results over time, a panel for each, several results laid over each other: "
                   "plot.svg in the folder of the first, or of --results")
      ->type_name("COLUMN,..")
      ->delimiter(',');
  command
      ->add_option("--chart", options->names, "Of a file: draw this chart alone (repeatable; default: all)")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--where", options->where, "Of a file: draw these rows alone, besides what the charts say")
      ->type_name("EXPRESSION");
  command
      ->add_option(
          "--results", options->results,
          "Folder of the tables; the charts go there too (default: where `tandem sweep` writes them)")
      ->type_name("DIR");
  command->add_flag("--png", options->png, "Draw PNG files too, besides SVG");
  command->footer(
      "The charts are drawn by the program gnuplot (Debian package gnuplot-nox); each leaves its script, "
      "NAME.gp.");
  command->callback([options, &context] { chart(*options, context); });
}

}  // namespace tandem::cli
