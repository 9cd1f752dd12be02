// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/sweep.hpp"

#include <fmt/format.h>

#include <chrono>
#include <mutex>

#include "tandem/output/parallel.hpp"

namespace tandem::two_mass {
output::KeyedTable sweep_table() {
  return {
      "schedule,to_fast,to_slow,frequency_ratio,position_error,energy_error,exchange_energy_error,"
      "amplitude_error,phase_error,exchanges,evaluations,position_error_exact,status,note",
      4};
}

output::KeyedTable timing_table() { return {"schedule,to_fast,to_slow,frequency_ratio,seconds", 4}; }

std::string sweep_key(const Case& c) {
  return fmt::format("{},{},{},{}", c.scheme.schedule, c.scheme.to_fast, c.scheme.to_slow, c.frequency_ratio);
}

std::string sweep_cells(const Outcome& o) {
  const Figures& f = o.figures;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}", output::cell(f.position_error),
                     output::cell(f.energy_error), output::cell(f.exchange_energy_error),
                     output::cell(f.amplitude_error), output::cell(f.phase_error), o.exchanges, o.evaluations,
                     output::cell(f.position_error_exact), f.failed ? "failed" : "ok", f.note);
}

void run_sweep(const SweepWork& work, const std::function<bool(std::size_t)>& tick) {
  std::vector<const Case*> open;
  for (const Case& c : work.cases)
    if (!work.rows.has(sweep_key(c))) open.push_back(&c);
  const std::size_t before = work.cases.size() - open.size();
  std::mutex mutex;
  const auto run = [&](std::size_t i) {
    const Case& c = *open[i];
    const auto started = std::chrono::steady_clock::now();
    const Outcome outcome = run_case(c);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started;
    const std::lock_guard lock(mutex);
    work.rows.set(sweep_key(c), sweep_cells(outcome));
    work.timings.set(sweep_key(c), fmt::format("{:.6g}", spent.count()));
  };
  output::for_each_in_parallel(open.size(), work.threads, run,
                               [&](std::size_t done) { return tick(before + done); });
}

}  // namespace tandem::two_mass
