// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "bench/bench.hpp"
#include "bench/heap.hpp"
#include "bench/linkage_timing.hpp"
#include "bench/meter.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/linear_solver.hpp"
#include "tandem/output/parallel.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::bench {
namespace {

using Cases = std::vector<LinkageCase>;

constexpr double end = 20.0;     // [s]
constexpr int most_dense = 100;  // loops, for dense solvers
constexpr int most_whole = 20;   // loops, for runs to the end by others than `auto`

int variables(const LinkageCase& c) { return 2 * c.loops + 2; }
bool runs_to_end(const LinkageCase& c) { return c.solver == "auto" || c.loops <= most_whole; }

/// Of a run to the end, roughly, on one core [s].
double time_to_end(const LinkageCase& c) {
  const double ns = (c.tolerance < 1e-6 ? 400.0 : 60.0) * (c.solver == "auto" ? 1.0 : 4.0);
  return 1e-9 * ns * end / c.step * variables(c);
}

bool is_dense(const std::string& solver) {
  return solver == "lapack" || solver == "lapack_lu" || solver == "eigen_dense";
}

Cases all_cases() {
  test::add_thesis_solvers();
  auto solvers = mbs::solver_names(mbs::MatrixKind::positive_definite);
  solvers.insert(solvers.begin() + 1, "generic");
  Cases all;
  for (const int loops : {1, 2, 5, 10, 20, 40, 100, 500, 4000})
    for (const double step : {1.25e-3, 1e-3})
      for (const double tolerance : {1e-5, 1e-10})
        for (const std::string& solver : solvers)
          if ((step > 1e-3 || solver == "auto") && (!is_dense(solver) || loops <= most_dense))
            all.push_back({solver, loops, step, tolerance});
  return all;
}

Cases only(Cases cases, bool (*wanted)(const LinkageCase&)) {
  std::erase_if(cases, [&](const LinkageCase& c) { return !wanted(c); });
  return cases;
}

class LinkageBench {
 public:
  explicit LinkageBench(const Tick& tick) : tick_(tick), meter_(cost()) {
    for (const LinkageCase& c : cases_) outcomes_[c];
  }
  /// On all cores, as nothing is timed; the longest first.
  void run_to_end();
  /// One at a time; those that differ in the solver alone take turns.
  void time();
  Table times() const;
  Table memory() const;

 private:
  double cost() const;
  void run_to_end(const LinkageCase& c);

  const Tick& tick_;
  const Cases cases_ = all_cases();
  const unsigned threads_ = std::max(1U, std::thread::hardware_concurrency());
  Meter meter_;
  LinkageOutcomes outcomes_;
};

double LinkageBench::cost() const {
  double total = timing_patience * static_cast<double>(cases_.size());
  for (const LinkageCase& c : only(cases_, runs_to_end)) total += time_to_end(c) / threads_;
  return total;
}

void LinkageBench::run_to_end() {
  Cases cases = only(cases_, runs_to_end);
  std::stable_sort(cases.begin(), cases.end(), [](const LinkageCase& a, const LinkageCase& b) {
    return time_to_end(a) > time_to_end(b);
  });
  output::for_each_in_parallel(
      cases.size(), threads_, [&](std::size_t i) { run_to_end(cases[i]); },
      [&](std::size_t) {
        tick_(meter_.share());
        return true;
      });
}

void LinkageBench::run_to_end(const LinkageCase& c) {
  constexpr int parts = 20;
  LinkageOutcome& outcome = outcomes_.at(c);
  try {
    mbs::Mechanism linkage(mbs::read_mechanism("four_bar", four_bar::text(c.loops)));
    LinkageRun run(c, linkage);
    const long steps = std::lround(end / c.step);
    for (long k = 0; k < parts; ++k) {
      run.steps((k + 1) * steps / parts - k * steps / parts);
      meter_.add(time_to_end(c) / parts / threads_);
    }
    outcome.x_error = run.x_error();
    outcome.drift = run.drift();
    outcome.at_end = true;
  } catch (const Error& error) {
    outcome.failure = error.what();
  }
}

void LinkageBench::time() {
  for (auto first = cases_.begin(); first != cases_.end();) {
    const auto next = std::find_if(first, cases_.end(), [&](const LinkageCase& c) {
      return c.loops != first->loops || c.step != first->step || c.tolerance != first->tolerance;
    });
    time_cases({first, next}, outcomes_);
    meter_.add(timing_patience * static_cast<double>(next - first));
    tick_(meter_.share());
    first = next;
  }
}

std::string status(const LinkageOutcome& o) {
  if (o.failure.empty()) return "ok";
  std::string sentence = "failed: " + o.failure;
  std::replace(sentence.begin(), sentence.end(), ',', ';');
  return sentence;
}

Table LinkageBench::times() const {
  Table table({"solver", "loops", "variables", "step", "newton_tolerance", "iterations_per_step",
               "ns_per_step_variable", "x_error", "energy_drift", "status"});
  for (const LinkageCase& c : cases_) {
    const LinkageOutcome& o = outcomes_.at(c);
    const int n = variables(c);
    table.add({c.solver, std::to_string(c.loops), std::to_string(n), fmt::format("{}", c.step),
               fmt::format("{}", c.tolerance), o.timed ? fmt::format("{:.3f}", o.iterations) : "",
               o.timed ? fmt::format("{:.1f}", 1e9 * o.seconds / n) : "",
               o.at_end ? fmt::format("{:.3e}", o.x_error) : "",
               o.at_end ? fmt::format("{:.2e}", o.drift) : "", status(o)});
  }
  return table;
}

/// In bytes a variable.
Table LinkageBench::memory() const {
  Table table({"solver", "loops", "variables", "mechanism", "stepper", "bytes_per_variable"}, "memory");
  for (const LinkageCase& c : cases_) {
    const LinkageOutcome& o = outcomes_.at(c);
    if (!heap_bytes() || !o.timed || c.step < 1.25e-3 || c.tolerance < 1e-5) continue;
    const double mechanism = o.mechanism_bytes / variables(c), stepper = o.stepper_bytes / variables(c);
    table.add({c.solver, std::to_string(c.loops), std::to_string(variables(c)),
               fmt::format("{:.0f}", mechanism), fmt::format("{:.0f}", stepper),
               fmt::format("{:.0f}", mechanism + stepper)});
  }
  return table;
}

}  // namespace

std::vector<Table> four_bar_linkage(const Tick& tick) {
  LinkageBench bench(tick);
  bench.run_to_end();
  bench.time();
  return {bench.times(), bench.memory()};
}

}  // namespace tandem::bench
