// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/bench.hpp"
#include "bench/linkage_methods.hpp"
#include "bench/linkage_trials.hpp"

namespace tandem::bench {
namespace {

using four_bar::Course;

constexpr LinkageMotion motions[] = {{"upright", four_bar::Start::upright, 20.0},
                                     {"upright 0.5 s", four_bar::Start::upright, 0.5},
                                     {"hanging", four_bar::Start::hanging, 20.0}};

constexpr int simbody_samples = 400, simbody_repetitions = 5, sizes[] = {1, 10, 40};
constexpr double finest = 1e-4;   // [m] beyond that nothing is asked
constexpr double patience = 1.0;  // [s] a run that takes longer is its method's last
constexpr double long_run = 0.1;  // [s] of these one repetition is enough

struct SimbodyRow {
  const LinkageMethod* method;
  double setting, seconds, error;
  std::size_t steps;
  std::string status;
};

/// All methods from coarse to fine, once.
std::vector<SimbodyRow> first_runs(const std::vector<LinkageMethod>& methods, const LinkageMotion& motion,
                                   int loops) {
  const double interval = motion.end / simbody_samples;
  const auto exact = four_bar::exact_path(loops, motion.start, interval, simbody_samples);
  std::vector<SimbodyRow> rows;
  for (const LinkageMethod& method : methods)
    for (const double setting : method.settings) {
      const Course course = method.run(setting, 2.0 * patience);
      const double error = rms_error(course, exact, interval);
      rows.push_back({&method, setting, course.seconds, error, course.knots.size() - 1, status(course)});
      if (course.seconds > patience || error < finest) break;
    }
  return rows;
}

/// In turn, so that what else the machine does meets all methods alike.
void repeat(std::vector<SimbodyRow>& rows) {
  for (int r = 1; r < simbody_repetitions; ++r)
    for (SimbodyRow& row : rows)
      if (row.status == "ok" && (r == 1 || row.seconds < long_run))
        row.seconds = std::min(row.seconds, row.method->run(row.setting, 2.0 * patience).seconds);
}

void add_simbody(Table& table, std::vector<LinkageTrial>& runs, const SimbodyRow& row,
                 const LinkageMotion& motion, int loops) {
  const LinkageMethod& method = *row.method;
  runs.push_back({method.code, motion.name, method.name, row.status, loops, row.error, row.seconds});
  table.add({method.code, motion.name, std::to_string(loops), method.name, runs.back().family(),
             fmt::format("{:.4g}", row.setting), std::to_string(row.steps),
             std::isfinite(row.error) ? fmt::format("{:.3e}", row.error) : "",
             fmt::format("{:.3e}", row.seconds), row.status});
}

}  // namespace

std::vector<Table> against_simbody(const Tick& tick) {
  Table table(
      {"code", "start", "loops", "method", "family", "accuracy", "steps", "rms_error", "seconds", "status"});
  std::vector<LinkageTrial> runs;
  double done = 0.0;
  for (const LinkageMotion& motion : motions)
    for (const int loops : sizes) {
      const LinkageMethods methods(motion, loops);
      std::vector<SimbodyRow> rows = first_runs(methods.all(), motion, loops);
      repeat(rows);
      for (const SimbodyRow& row : rows) add_simbody(table, runs, row, motion, loops);
      tick(++done / static_cast<double>(std::size(motions) * std::size(sizes)));
    }
  return {table, ratios(runs)};
}

}  // namespace tandem::bench
