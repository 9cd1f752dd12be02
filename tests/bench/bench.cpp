// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"

namespace tandem::bench {
namespace {

/// Keeps the least of the repetitions, prints nothing.
class Least final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name == "least")
        seconds[run.run_name.function_name] =
            run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
  }
  std::map<std::string, double> seconds;
};

}  // namespace

std::map<std::string, double> measure(const std::vector<Timing>& timings, int repetitions,
                                      double seconds_each) {
  std::vector<std::string> words = {"tandem", "--benchmark_enable_random_interleaving=true",
                                    fmt::format("--benchmark_min_time={}", seconds_each)};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  for (const Timing& t : timings) {
    auto* registered = benchmark::RegisterBenchmark(t.name.c_str(), t.run);
    registered->Repetitions(repetitions)->ReportAggregatesOnly(true)->UseRealTime();
    registered->ComputeStatistics(
        "least", [](const std::vector<double>& all) { return *std::min_element(all.begin(), all.end()); });
  }
  Least least;
  benchmark::RunSpecifiedBenchmarks(&least);
  benchmark::ClearRegisteredBenchmarks();
  return least.seconds;
}

void Table::print() const {
  std::vector<std::size_t> widths;
  for (const std::string& column : columns_) widths.push_back(column.size());
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += fmt::format("{:<{}}  ", cells[i], widths[i]);
    fmt::print("{}\n", text.substr(0, text.find_last_not_of(' ') + 1));
  };
  line(columns_);
  for (const auto& row : rows_) line(row);
}

void Table::write(const std::filesystem::path& stem, const Benchmark& benchmark) const {
  std::string text = fmt::format("{}\n", fmt::join(columns_, ","));
  for (const auto& row : rows_) text += fmt::format("{}\n", fmt::join(row, ","));
  output::write_text(stem.string() + ".csv", text);
  const nlohmann::ordered_json about = {{"norms", benchmark.norms}, {"made", output::made()}};
  output::write_text(stem.string() + ".json", about.dump(2) + "\n");
}

const std::vector<Benchmark>& all() {
  const auto one = [](Table (*run)()) { return [run](const Tick&) { return std::vector{run()}; }; };
  static const std::vector<Benchmark> list = {
    {"exchange",
     "one round of in-process null subsystems, beside a hand-written loop; a turn among 2 to 20 000 of them",
     [](const Tick&) {
       return std::vector{exchange(), topologies(), round_threads()};
     }},
    {"impulse",
     "whole runs by impulse coupling, beside those by samples of the force",
     [](const Tick& tick) { return std::vector{impulse(tick)}; },
     {{"ns_per_fast_step", "the least of 100 runs, in turns"}}},
    {"indicators",
     "whole runs of scenes with their indicators and without",
     [](const Tick& tick) { return std::vector{indicators(tick)}; },
     {{"ns_per_connection_and_step", "the least of 40 to 400 runs, in turns; steps of the finer side"}}},
    {"two_mass", "a run of the two-mass test split into its sides and the coordinator", one(two_mass)},
    {"formulations",
     "every formulation and integrator on every example mechanism: error, order, drift and residuals",
     [](const Tick& tick) { return std::vector{formulations(tick)}; }},
    {"mechanisms",
     "the same, error and processor time with four steps, by halves",
     [](const Tick& tick) { return std::vector{mechanisms(tick)}; },
     {{"error", "distance from the truth at the end"}, {"seconds", "processor time, the least of up to 5"}}},
    {"linkage_errors",
     "20 s of the N-fold four-bar linkage: error, drift and residuals by formulation, integrator, step and "
     "tolerance; "
     "and the linkage of two loops through its flat position",
     linkage_errors,
     {{"x_error", "x of the first moving point at 20 s, from the exact motion"}}},
    {"four_bar",
     "a step of the N-fold four-bar linkage by each solver, in ns a variable, and its iterations, of the "
     "first "
     "of 20 s; error and drift at their end; the memory, in bytes a variable",
     four_bar_linkage,
     {{"ns_per_step_variable", "the least of several in turns"}}},
    {"hand_written",
     "a step of the linkage and its terms alone, in ns a variable, beside a model written for it alone",
     one(hand_written_linkage)},
    {"sparse", "the prepared sparse algebra on the linkage's matrices, beside plain expressions of Eigen",
     one(sparse_algebra)},
    {"solvers",
     "a factorization and two solutions by each linear solver, over kind, size and filling",
     [](const Tick&) { return linear_solvers(); },
     {{"auto", "the least of 5"}}},
    {"dense",
     "products and Cholesky's factorization with one solution of small dense matrices by each BLAS",
     one(dense_algebra),
     {{"ns", "the least of 10"}}},
    {"threads",
     "a step of the linkage, in ns a variable, by the number of threads, over its size",
     one(threads),
     {{"speed_up", "the least of 15"}}},
    {"profile", "the share of each task of a step of the linkage, in a build with -DTANDEM_PROFILE=ON",
     one(profile)},
    {"integrators", "a step of 1 ms of oscillators as compiled diagrams, beside functions written by hand",
     one(integrators)},
    {"functions",
     "10 s of the double pendulum with its terms evaluated in C++, by Octave through a pipe, in a shared "
     "library, "
     "and from Octave (MEX)",
     one(function_evaluation)},
    {"engine", "a step of 0.1 ms of the models of scenarios/engine, of listed blocks and with blocks in C++",
     one(engine_models)},
    {"transports",
     "round trips of an advance over each transport, and large vectors, beside the same bytes without tandem",
     transports,
     {{"median_us", "of 4000, in turns with the same bytes by the system's or ZeroMQ's own calls"}}},
#if TANDEM_HAS_FMI
    {"fmu",
     "a step of an FMU whose step takes 1 us, beside the same calls made directly",
     one(fmu),
     {{"ns_tandem", "the median of 4000, in turns"}}},
#endif
    {"engine_linkage",
     "30 s of the engine-linkage scene with one side in another process or in a shared library, beside both "
     "in "
     "this one",
     [](const Tick& tick) { return std::vector{engine_linkage_elsewhere(tick)}; },
     {{"seconds", "the median of 3, in turns"}}},
#if TANDEM_HAS_SIMBODY
    {"simbody",
     "the linkage by tandem and by Simbody: error and processor time",
     against_simbody,
     {{"rms_error", "rms of the first point's distance from the exact motion"},
      {"seconds", "processor time, the least of 2 to 5"}}},
#endif
  };
  return list;
}

}  // namespace tandem::bench
