// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "scenario/comparison.hpp"

namespace tandem::cli {
namespace {

struct Options {
  std::string a, b;
  double tolerance = 0.0;
  std::vector<std::string> columns;
};

void compare(const Options& options, const Context& context) {
  const auto a = scenario::Table::read(options.a), b = scenario::Table::read(options.b);
  const auto comparison = scenario::compare(a, b, options.columns);
  if (!context.quiet) fmt::print("{}", scenario::text(comparison));
  if (const std::string difference = scenario::beyond(comparison, options.tolerance); !difference.empty())
    throw RunFailed(difference);
  if (!context.quiet) fmt::print("within the tolerance of {:.3g} %\n", 100.0 * options.tolerance);
}

}  // namespace

void add_compare(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("compare", "Tell where and by how much two results differ most");
  auto options = std::make_shared<Options>();
  command->add_option("A", options->a, "Results: a CSV file, or a folder that holds results.csv")->required();
  command->add_option("B", options->b, "What to compare with, likewise")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "Allowed difference, a fraction of the largest magnitude of the column in B; 0: equal")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--columns", options->columns, "Columns to compare (default: all that both have)")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->footer(
      "Compared at the times of the one with fewer rows where both cover the time; where the other has no "
      "row there, it is\n"
      "interpolated linearly. Empty cells are left out. Exit status: 0 within the tolerance, 1 beyond, 2 bad "
      "input.");
  command->callback([options, &context] { compare(*options, context); });
}

}  // namespace tandem::cli
