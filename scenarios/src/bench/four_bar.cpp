// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/bench.hpp"
#include "bench/generic_index3.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

constexpr double end = 20.0, alpha = 1e8;
constexpr int widest_dense = 100;
constexpr double patience = 0.5;  // [s] for 20 s of the linkage by a solver other than `auto`

struct Row {
  std::string solver;
  int loops;
  double step, tolerance;
};

struct Outcome {
  double seconds_per_step = 1e300, iterations = 0.0;
  double x_error = 0.0, drift = 0.0;
  std::string status = "ok";
};

std::unique_ptr<mbs::Stepper> stepper(const Row& row, mbs::Mechanism& linkage) {
  if (row.solver == "generic") return std::make_unique<GenericIndex3>(linkage, alpha, row.tolerance);
  mbs::Index3Settings settings;
  settings.penalty = alpha;
  settings.tolerance = row.tolerance;
  settings.solver = row.solver;
  return std::make_unique<mbs::Index3>(linkage, settings);
}

/// A run from the start.
class Run {
 public:
  Run(const Row& row, mbs::Mechanism& linkage)
      : row_(row), linkage_(linkage), stepper_(stepper(row, linkage)), s_(linkage.described_state()) {
    stepper_->start(s_);
    energy_ = linkage_.energy(s_.q.data(), s_.v.data());
  }
  /// Seconds for so many steps more.
  double steps(long count) {
    const auto began = std::chrono::steady_clock::now();
    for (long k = 0; k < count; ++k, ++done_)
      iterations_ += stepper_->step(s_, row_.step, static_cast<double>(done_ + 1) * row_.step);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }
  void tell(Outcome& o) const {
    o.iterations = static_cast<double>(iterations_) / static_cast<double>(done_);
    o.x_error = std::abs(s_.q[linkage_.coordinate(0)] - std::sin(four_bar::exact(row_.loops, s_.time).angle));
    o.drift = linkage_.energy(s_.q.data(), s_.v.data()) - energy_;
  }

 private:
  const Row& row_;
  mbs::Mechanism& linkage_;
  std::unique_ptr<mbs::Stepper> stepper_;
  mbs::State s_;
  double energy_;
  long done_ = 0, iterations_ = 0;
};

/// The whole 20 s (for `auto` whatever it takes, for others within patience), else a part, of which errors
/// say nothing. The least time a step of three beginnings and the run.
Outcome run(const Row& row, mbs::Mechanism& linkage) {
  Outcome o;
  try {
    const int few = std::clamp(200'000 / linkage.structure().variables, 20, 400);
    for (int r = 0; r < 3; ++r)
      o.seconds_per_step = std::min(o.seconds_per_step, Run(row, linkage).steps(few) / few);
    const long all = std::lround(end / row.step);
    const bool whole = row.solver == "auto" || o.seconds_per_step * static_cast<double>(all) < patience;
    const long count = whole ? all : few;
    Run last(row, linkage);
    o.seconds_per_step = std::min(o.seconds_per_step, last.steps(count) / static_cast<double>(count));
    last.tell(o);
    if (!whole) o.status = "timed";
  } catch (const Error&) {
    o.status = "failed";
  }
  return o;
}

void add(Table& table, const Row& row, mbs::Mechanism& linkage) {
  const int n = linkage.structure().variables;
  const Outcome o = run(row, linkage);
  const bool ran = o.status != "failed", whole = o.status == "ok";
  const double falls = 9.81 * (1.5 * row.loops + 0.5);  // potential energy at the start
  table.add({row.solver, std::to_string(row.loops), std::to_string(n), fmt::format("{}", row.step),
             fmt::format("{}", row.tolerance), ran ? fmt::format("{:.3f}", o.iterations) : "",
             ran ? fmt::format("{:.1f}", 1e9 * o.seconds_per_step / n) : "",
             whole ? fmt::format("{:.3e}", o.x_error) : "",
             whole ? fmt::format("{:.2e}", std::abs(o.drift) / falls) : "", o.status});
}

bool is_dense(const std::string& solver) {
  return solver == "lapack" || solver == "lapack_lu" || solver == "eigen_dense";
}

}  // namespace

Table four_bar_linkage() {
  Table table({"solver", "loops", "variables", "step", "newton_tolerance", "iterations_per_step",
               "ns_per_step_variable", "x_error", "energy_drift", "status"});
  auto solvers = mbs::solver_names(mbs::MatrixKind::positive_definite);
  solvers.insert(solvers.begin() + 1, "generic");
  for (const int loops : {1, 2, 5, 10, 20, 40, 100, 500, 4000}) {
    mbs::Mechanism linkage(mbs::read_mechanism("four_bar", four_bar::text(loops)));
    for (const double step : {1.25e-3, 1e-3})
      for (const double tolerance : {1e-5, 1e-10})
        for (const std::string& solver : solvers)
          if ((step > 1e-3 || solver == "auto") && (!is_dense(solver) || loops <= widest_dense))
            add(table, {solver, loops, step, tolerance}, linkage);
  }
  return table;
}

}  // namespace tandem::bench
