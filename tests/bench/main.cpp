// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The program of benchmarks: `tandem bench` starts it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/bench.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/lock.hpp"
#include "tandem/output/progress.hpp"
#include "tandem/output/provenance.hpp"

namespace tandem::bench {
namespace {

void run(const Benchmark& benchmark, const std::filesystem::path& folder, bool quiet) {
  if (!quiet) fmt::print("{}; {}, {}\n", benchmark.about, output::processor_model(), output::compiler());
  const output::FolderLock kept(
      folder, [](const std::string& what) { output::show_progress("note: " + what + "\n"); });
  std::vector<Table> tables;
  {
    output::Progress progress(benchmark.name, 100, !quiet);
    tables = benchmark.run([&](double share) { progress.update(static_cast<std::size_t>(100.0 * share)); });
  }
  for (const Table& table : tables) {
    const std::string name = benchmark.name + (table.name().empty() ? "" : "_" + table.name());
    table.print();
    table.write(folder / name, benchmark);
    if (!quiet) fmt::print("wrote {}\n", (folder / (name + ".csv")).string());
  }
}

int main(int argc, char** argv) {
  CLI::App app("Times parts of tandem; prints a table and writes NAME.csv", "tandem bench");
  std::string name, folder = "results/bench";
  bool quiet = false;
  std::vector<std::string> names;
  std::string about = "What to time:";
  for (const Benchmark& b : all()) {
    names.push_back(b.name);
    about += "\n  " + b.name + ": " + b.about;
  }
  app.add_option("name", name, about)->required();
  app.add_option("--output", folder, "Folder for the CSV file")->type_name("DIR")->capture_default_str();
  app.add_flag("--quiet", quiet, "Print tables and errors only");
  app.footer("`tandem chart tests/bench/charts.toml --chart NAME` draws results/bench.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto chosen =
      std::find_if(all().begin(), all().end(), [&](const Benchmark& b) { return b.name == name; });
  if (chosen == all().end()) throw Error(ErrorCode::invalid_argument, unknown("benchmark", name, names));
  run(*chosen, folder, quiet);
  return 0;
}

}  // namespace
}  // namespace tandem::bench

int main(int argc, char** argv) {
  try {
    return tandem::bench::main(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "tandem: {}\n", error.what());
    return 2;
  }
}
