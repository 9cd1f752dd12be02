// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "tandem/output/files.hpp"
#include "two_mass/sweep.hpp"

namespace tandem::two_mass {
namespace {

/// The runs whose motion or energy the charts draw.
std::vector<Case> traced() {
  std::vector<Case> cases;
  for (const Scheme& s :
       {Scheme{"slowest-first", "lagrange0", "lagrange0"}, Scheme{"fastest-first", "lagrange3", "lagrange3"},
        Scheme{"fastest-first", "lagrange3", "mean"}})
    cases.push_back({s, 90.0});
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    cases.push_back({{schedule, "lagrange3", "lagrange3"}, 30.0});
  cases.push_back({{"slowest-first", "lagrange0", "lagrange0"}, 30.0});
  cases.push_back({{"staggered", "matched_hold", "matched_hold"}, 30.0});
  return cases;
}

std::string least_time(const Case& c, int repetitions) {
  double least = time_case(c);
  for (int i = 1; i < repetitions; ++i) least = std::min(least, time_case(c));
  return fmt::format("{}", least);
}

}  // namespace

void write_traces(const std::filesystem::path& file) {
  std::string text = "frequency_ratio,schedule,to_fast,to_slow,time,x1,x1_exact,energy_error\n";
  for (const Case& c : traced())
    run_case(c, [&](const Model& model, const Measures& measures) {
      const auto energies = measures.energy_errors();
      const auto& nodes = measures.nodes();
      for (std::size_t k = 0; k < std::min(nodes.size(), energies.size()); ++k)
        text += fmt::format("{},{},{},{},{},{},{},{}\n", c.frequency_ratio, c.scheme.schedule,
                            c.scheme.to_fast, c.scheme.to_slow, nodes[k].time, nodes[k].x1,
                            model.exact(nodes[k].time).x1, energies[k]);
    });
  output::write_text(file, text);
}

std::vector<Case> work_cases() {
  std::vector<Scheme> schemes = sweep_schemes(false);
  schemes.push_back({"monolithic", "", ""});
  std::vector<Case> cases;
  for (const double ratio : {10.0, 30.0, 90.0})
    for (const Scheme& s : schemes)
      for (const double steps : {25.0, 50.0, 100.0, 200.0, 400.0}) cases.push_back({s, ratio, 100.0, steps});
  return cases;
}

output::KeyedTable work_table() {
  return {
      "schedule,to_fast,to_slow,frequency_ratio,steps_per_cycle,position_error,amplitude_error,"
      "phase_error,exchanges,evaluations,seconds,repetitions,position_error_exact,status",
      5};
}

std::string work_key(const Case& c) { return fmt::format("{},{}", sweep_key(c), c.steps_per_cycle); }

std::string work_cells(const Case& c, int repetitions) {
  const Outcome o = run_case(c);
  return fmt::format("{},{},{},{},{},{},{},{},{}", output::cell(o.figures.position_error),
                     output::cell(o.figures.amplitude_error), output::cell(o.figures.phase_error),
                     o.exchanges, o.evaluations,
                     o.figures.failed ? std::string() : least_time(c, repetitions), repetitions,
                     output::cell(o.figures.position_error_exact), o.figures.failed ? "failed" : "ok");
}

}  // namespace tandem::two_mass
