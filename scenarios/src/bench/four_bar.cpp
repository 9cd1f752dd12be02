// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/bench.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

constexpr double end = 20.0, alpha = 1e8;

struct Row {
  std::string solver;
  int loops;
  double step, tolerance;
};

struct Outcome {
  double seconds = 1e300, iterations = 0.0, x_error = 0.0, drift = 0.0;
  std::string status = "ok";
};

/// 20 s of the linkage; the least time of the repetitions.
Outcome run(const Row& row, mbs::Mechanism& linkage, int repetitions) {
  mbs::Index3Settings settings;
  settings.penalty = alpha;
  settings.tolerance = row.tolerance;
  settings.solver = row.solver;
  mbs::Index3 formulation(linkage, settings);
  const auto steps = std::lround(end / row.step);
  Outcome outcome;
  for (int r = 0; r < repetitions; ++r) try {
      mbs::State s = linkage.described_state();
      formulation.start(s);
      const double e0 = linkage.energy(s.q.data(), s.v.data());
      long iterations = 0;
      const auto began = std::chrono::steady_clock::now();
      for (long k = 0; k < steps; ++k) iterations += formulation.step(s, row.step);
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
      outcome.seconds = std::min(outcome.seconds, spent.count());
      outcome.iterations = static_cast<double>(iterations) / static_cast<double>(steps);
      outcome.x_error =
          std::abs(s.q[linkage.coordinate(0)] - std::sin(four_bar::exact(row.loops, end).angle));
      outcome.drift = linkage.energy(s.q.data(), s.v.data()) - e0;
    } catch (const Error&) {
      outcome.status = "failed";
      return outcome;
    }
  return outcome;
}

void add(Table& table, const Row& row) {
  mbs::Mechanism linkage(mbs::read_mechanism("four_bar", four_bar::text(row.loops)));
  const int n = linkage.structure().variables;
  const Outcome o = run(row, linkage, std::clamp(4000 / n, 1, 5));
  const double steps = end / row.step;
  const bool ok = o.status == "ok";
  const double falls = 9.81 * (1.5 * row.loops + 0.5);  // potential energy at the start
  table.add({row.solver, std::to_string(row.loops), std::to_string(n), fmt::format("{}", row.step),
             fmt::format("{}", row.tolerance), ok ? fmt::format("{:.3f}", o.iterations) : "",
             ok ? fmt::format("{:.1f}", 1e9 * o.seconds / steps / n) : "",
             ok ? fmt::format("{:.3e}", o.x_error) : "",
             ok ? fmt::format("{:.2e}", std::abs(o.drift) / falls) : "", o.status});
}

}  // namespace

Table four_bar_linkage() {
  Table table({"solver", "loops", "variables", "step", "newton_tolerance", "iterations_per_step",
               "ns_per_step_variable", "x_error", "energy_drift", "status"});
  for (const double tolerance : {1e-5, 1e-10})
    for (const int loops : {1, 2, 5, 10, 20, 40, 100, 500})
      for (const char* solver : {"auto", "band", "prepared", "klu", "ldlt"})
        add(table, {solver, loops, 1.25e-3, tolerance});
  return table;
}

}  // namespace tandem::bench
