// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "output/keyed_table.hpp"
#include "two_mass/experiment.hpp"

namespace tandem::two_mass {

/// sweep.csv: a row for each case; and sweep_timings.csv, the seconds that each took. The same key.
output::KeyedTable sweep_table();
output::KeyedTable timing_table();
std::string sweep_key(const Case& c);
std::string sweep_cells(const Outcome& outcome);

/// What a sweep has to do: the cases that `rows` has not, on that many threads.
struct SweepWork {
  const std::vector<Case>& cases;
  unsigned threads;
  output::KeyedTable &rows, &timings;
};

/// Does it. Each case is deterministic, so the rows do not depend on their order. `tick(done)` is called from
/// the calling thread now and then; if it returns false the sweep ends with what is done.
void run_sweep(const SweepWork& work, const std::function<bool(std::size_t)>& tick);

/// traces.csv: x1 and the energy error over time for the runs that the charts show.
void write_traces(const std::filesystem::path& file);

/// work.csv, of the speed-against-accuracy chart: its cases; a row of it is a case, its errors, and the least
/// time of `repetitions` runs.
std::vector<Case> work_cases();
output::KeyedTable work_table();
std::string work_key(const Case& c);
std::string work_cells(const Case& c, int repetitions);

}  // namespace tandem::two_mass
