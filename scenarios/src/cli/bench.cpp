// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "output/conditions.hpp"
#include "output/files.hpp"

namespace tandem::cli {
namespace {

/// What a chart of the benchmark tells beside its figures.
void write_conditions(const bench::Benchmark& benchmark, const std::filesystem::path& folder) {
  auto conditions = output::conditions(0);
  conditions["reference"] = benchmark.notes->reference;
  conditions["error_norm"] = benchmark.notes->error_norm;
  conditions["repetitions"] = benchmark.notes->repetitions;
  output::write_text(folder / (benchmark.name + "_conditions.json"), conditions.dump(2) + "\n");
}

}  // namespace

void add_bench(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("bench", "Time a part of tandem; prints a table and writes results/bench/NAME.csv");
  auto name = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>("results/bench");
  std::vector<std::string> names;
  std::string about = "What to time:";
  for (const auto& b : bench::all()) {
    names.push_back(b.name);
    about += "\n  " + b.name + ": " + b.about;
  }
  command->add_option("name", *name, about)->required()->check(CLI::IsMember(names));
  command->add_option("--output", *folder, "Folder for the CSV file")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback([name, folder, &context] {
    for (const auto& b : bench::all()) {
      if (b.name != *name) continue;
      if (!context.quiet) fmt::print("{}; {}, {}\n", b.about, output::processor_model(), TANDEM_COMPILER);
      output::make_folder(*folder);
      const bench::Table table = b.run();
      table.print();
      const auto file = std::filesystem::path(*folder) / (b.name + ".csv");
      table.write(file);
      if (b.notes) write_conditions(b, *folder);
      if (!context.quiet) fmt::print("wrote {}\n", file.string());
    }
  });
}

}  // namespace tandem::cli
