// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/about.hpp"
#include "tandem/scenario/comparison.hpp"

namespace tandem::cli {
namespace {

struct CompareOptions {
  std::string a, b, norm = "max";
  double tolerance = 0.0;
  std::vector<std::string> columns;
  scenario::Measure measure;
};

namespace fs = std::filesystem;

/// The files of a folder's results, as its results.json says; results.csv without one; none for a file.
std::vector<std::string> files_in(const fs::path& place) {
  if (!fs::is_directory(place)) return {};
  if (!fs::exists(place / "results.json")) return {"results.csv"};
  return scenario::read_about(place)["files"].get<std::vector<std::string>>();
}

/// The pairs of files that belong together.
std::vector<std::pair<fs::path, fs::path>> pairs_of(const CompareOptions& options) {
  const auto in_a = files_in(options.a), in_b = files_in(options.b);
  const auto one = [](const std::string& place, const std::vector<std::string>& files) {
    return files.empty() ? fs::path(place) : fs::path(place) / files[0];
  };
  if (in_a.size() <= 1 && in_b.size() <= 1) return {{one(options.a, in_a), one(options.b, in_b)}};
  if (in_a != in_b)
    throw Error(ErrorCode::invalid_argument, options.a + " holds " + listed(in_a) + ", " + options.b +
                                                 " holds " + listed(in_b) + "; name two files");
  std::vector<std::pair<fs::path, fs::path>> pairs;
  for (const std::string& file : in_a)
    pairs.emplace_back(fs::path(options.a) / file, fs::path(options.b) / file);
  return pairs;
}

void compare(const CompareOptions& options, const Context& context) {
  std::string worst;
  const auto pairs = pairs_of(options);
  for (const std::string& place : {options.a, options.b})
    if (const std::string what = scenario::unfinished(place); !what.empty()) spdlog::warn("note: {}", what);
  for (const auto& [file_a, file_b] : pairs) {
    const auto a = text::TimeTable::read(file_a), b = text::TimeTable::read(file_b);
    const auto comparison = scenario::compare(a, b, options.columns, options.measure);
    if (!context.quiet) say("{}", scenario::text(comparison));
    if (worst.empty()) worst = scenario::beyond(comparison, options.tolerance, options.measure.norm);
  }
  if (!worst.empty()) throw RunFailed(worst);
  if (!context.quiet) say("within the tolerance of {:.3g} %\n", 100.0 * options.tolerance);
}

}  // namespace

void add_compare(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("compare", "Tell where and by how much two results differ most");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("A", options->a, "Results: a CSV file, or the folder of a run")->required();
  command->add_option("B", options->b, "What to compare with, likewise")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "Allowed difference, a fraction of the largest magnitude, or of the rms, of the column in "
                   "B; 0: equal")
      ->check(not_negative)
      ->capture_default_str();
  command->add_option("--columns", options->columns, "Columns to compare (default: all that both have)")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_option("--norm", options->norm, "What the tolerance is of: the largest difference, or the rms")
      ->check(one_of({"max", "rms"}))
      ->capture_default_str();
  command->add_option("--from", options->measure.from, "The first time of B that counts, in s")
      ->check(number)
      ->type_name("TIME");
  command->add_option("--to", options->measure.to, "The last time of B that counts, in s")
      ->check(number)
      ->type_name("TIME");
  command
      ->add_option("--shift", options->measure.shift,
                   "A may be this much earlier or later as a whole, in s; by how much it is is told")
      ->check(positive)
      ->type_name("TIME");
  command->footer(
      "Compared at the times of the one with fewer rows where both cover the time; where the other has no "
      "row there, it is\n"
      "interpolated, by Hermite polynomials if it has the column der(NAME) (record.derivatives), else "
      "linearly.\n"
      "Empty cells are left out. Columns (unless named) and times that only one "
      "has are a difference.\n"
      "Exit status: 0 within the tolerance, 1 beyond, 2 bad input.");
  command->callback([options, &context] {
    options->measure.norm = options->norm == "rms" ? scenario::Norm::rms : scenario::Norm::max;
    compare(*options, context);
  });
}

}  // namespace tandem::cli
