// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "output/conditions.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/provenance.hpp"

namespace tandem::cli {
namespace {

void run_benchmark(const bench::Benchmark& benchmark, const std::filesystem::path& folder,
                   const Context& context) {
  if (!context.quiet) say("{}; {}, {}\n", benchmark.about, output::processor_model(), output::compiler());
  const KeptFolder kept(folder);
  std::vector<bench::Table> tables;
  {
    Progress progress(benchmark.name, 100, !context.quiet);
    tables = benchmark.run([&](double share) { progress.update(static_cast<std::size_t>(100.0 * share)); });
  }
  for (const bench::Table& table : tables) {
    table.print();
    const std::string name = benchmark.name + (table.name().empty() ? "" : "_" + table.name());
    table.write(folder / (name + ".csv"));
    if (!context.quiet) say("wrote {}\n", (folder / (name + ".csv")).string());
  }
  if (benchmark.measured)
    output::write_text(folder / (benchmark.name + "_conditions.json"),
                       output::conditions(*benchmark.measured).dump(2) + "\n");
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
    for (const auto& b : bench::all())
      if (b.name == *name) run_benchmark(b, *folder, context);
  });
}

}  // namespace tandem::cli
