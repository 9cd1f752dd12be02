// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_four_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "four_bar/sweep.hpp"
#include "output/conditions.hpp"
#include "output/meter.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/parallel.hpp"

namespace tandem::cli {
namespace {

void stop_if_interrupted(const four_bar::Place&) {
  if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing is written");
}

std::vector<four_bar::Result> run_cases(const std::vector<four_bar::Case>& cases, unsigned threads,
                                        bool shown) {
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto cost = [&](std::size_t i) { return four_bar::sweep_cost(cases[i]); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return cost(a) > cost(b); });
  output::Meter meter(std::transform_reduce(order.begin(), order.end(), 0.0, std::plus<>(), cost));
  Progress progress("sweep", 100, shown);
  std::vector<four_bar::Result> results(cases.size());
  output::for_each_in_parallel(
      cases.size(), threads,
      [&](std::size_t i) {
        results[order[i]] = four_bar::run(cases[order[i]], four_bar::sweep_end, stop_if_interrupted);
        meter.add(cost(order[i]));
      },
      [&](std::size_t) {
        progress.update(static_cast<std::size_t>(100.0 * meter.share()));
        return !InterruptGuard::interrupted();
      });
  return results;
}

}  // namespace

void sweep_four_bar(const std::filesystem::path& folder, unsigned threads, const Context& context) {
  const InterruptGuard guard;
  const KeptFolder kept(folder);
  const auto cases = four_bar::sweep_cases();
  const auto results = run_cases(cases, threads, !context.quiet);
  if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing is written");
  output::write_text(folder / "four_bar.csv", four_bar::sweep_table(cases, results));
  four_bar::write_traces(folder / "four_bar_traces.csv");
  const output::Measured measured{
      "exact motion", "x of the first moving point at 20 s (errors); tilt (motion)", "none, no times"};
  output::write_text(folder / "four_bar_conditions.json", output::conditions(measured).dump(2) + "\n");
  if (!context.quiet) say("wrote {}\n", (folder / "four_bar.csv").string());
}

}  // namespace tandem::cli
