// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Maps of the best linear solver over size and filling, for each kind of matrix; and what the rule of `auto`
// is fitted to.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "bench/bench.hpp"
#include "bench/solver_fit.hpp"
#include "bench/tangent_problem.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/sparse/solver_choice.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::bench {
namespace {

using mbs::MatrixKind;
using Clock = std::chrono::steady_clock;

constexpr int solver_repetitions = 5, solutions_each = 2;
constexpr double batch = 1e-4;           ///< [s] the least time of a repetition
constexpr double not_close = 10.0;       ///< times the best: measured once only
constexpr double well_measured = 20.0;   ///< times the best: counts for the fit
constexpr double hopeless = 30.0;        ///< times the best, and slow_solution: not tried at larger sizes
constexpr double slow_solution = 1e-2;   ///< [s]
constexpr double most_operations = 2e8;  ///< of a factorization
constexpr std::size_t most_values = 6'000'000;

struct Kind {
  MatrixKind kind;
  const char* name;
};
constexpr Kind kinds[] = {{MatrixKind::positive_definite, "positive definite"},
                          {MatrixKind::symmetric, "symmetric"},
                          {MatrixKind::unsymmetric, "unsymmetric"}};

/// F. Gonzalez, doctoral thesis, A Coruna 2010, chapter 3: dense below some 50 variables, KLU for few
/// non-zeros, CHOLMOD for more of them in definite matrices. What counts as few is not said as a number; here
/// what the linkage has without artificial ones, 12 a row at most.
std::string thesis_choice(MatrixKind kind, int variables, int entries) {
  if (variables < 50) return kind == MatrixKind::unsymmetric ? "lapack_lu" : "lapack";
  return kind == MatrixKind::positive_definite && entries > 12 ? "cholmod" : "klu";
}

/// A solver at work on a problem: factorizes one matrix after the other, each with its solutions.
class Runner {
 public:
  Runner(const std::string& name, MatrixKind kind, const TangentProblem& problem)
      : name_(name), solver_(mbs::make_solver(name, kind)) {
    solver_->analyze(problem.pattern);
    const auto layout = solver_->layout();
    if (layout.size() > most_values) throw Error(ErrorCode::not_supported, "too large");
    for (const auto& values : problem.values) {
      auto& to = sets_.emplace_back();
      for (const auto& [row, column] : layout) {
        const int at = row < 0 ? -1 : problem.pattern.find(row, column);
        to.push_back(at < 0 ? 0.0 : values[at]);
      }
    }
    storage_.resize(layout.size());
    b_.resize(static_cast<std::size_t>(problem.pattern.columns()));
    seconds_ = time_of(1);
    if (seconds_ < slow_solution)
      seconds_ = time_of(4);  // the first is another: pages, caches, KLU's full factors
    rounds_ = std::max(1, static_cast<int>(batch / seconds_));
  }

  const std::string& name() const { return name_; }
  double seconds() const { return seconds_; }
  void repeat() { seconds_ = std::min(seconds_, time_of(rounds_)); }

 private:
  double time_of(int rounds) {
    const auto began = Clock::now();
    for (int k = 0; k < rounds; ++k) {
      next_ = (next_ + 1) % sets_.size();
      std::copy(sets_[next_].begin(), sets_[next_].end(), storage_.begin());
      if (solver_->factorize(storage_.data()) >= 0) throw Error(ErrorCode::numerical, "singular");
      for (int s = 0; s < solutions_each; ++s) {
        std::fill(b_.begin(), b_.end(), 1.0);
        solver_->solve(b_.data());
      }
    }
    return std::chrono::duration<double>(Clock::now() - began).count() / rounds;
  }

  std::string name_;
  std::unique_ptr<mbs::LinearSolver> solver_;
  std::vector<std::vector<double>> sets_;
  std::vector<double> storage_, b_;
  std::size_t next_ = 0;
  int rounds_ = 1;
  double seconds_ = 1e300;
};

/// The sizes at one kind and filling, from small to large; solvers drop out on the way.
class Row {
 public:
  Row(const Kind& kind, Placement placement, int entries)
      : kind_(kind), placement_(placement), entries_(entries), names_(mbs::solver_names(kind.kind)) {}

  void add_size(Table& table, Table& best, SolverFit& fit, int variables) {
    const TangentProblem problem = tangent_problem({kind_.kind, placement_, variables, entries_});
    const auto cost = mbs::elimination_cost(problem.pattern);
    if (cost.operations > most_operations) return;
    std::vector<Runner> runners;
    for (const std::string& name : names_) try {
        runners.emplace_back(name, kind_.kind, problem);
      } catch (const Error&) {  // too large for it, and so for what comes after
      }
    for (int r = 0; r < solver_repetitions; ++r) {
      const double limit = not_close * least(runners, "");
      for (Runner& runner : runners)
        if (runner.seconds() <= limit) runner.repeat();
    }
    write(table, best, problem.pattern, variables, runners);
    for (const Runner& r : runners)
      if (r.seconds() <= well_measured * least(runners, "")) fit.add(kind_.name, r.name(), cost, r.seconds());
  }

 private:
  /// Of all but one.
  static double least(const std::vector<Runner>& runners, const std::string& but) {
    double best = 1e300;
    for (const Runner& r : runners)
      if (r.name() != but && r.name() != "auto") best = std::min(best, r.seconds());
    return best;
  }

  /// Not a number: it is not there, or has dropped out.
  static double seconds_of(const std::vector<Runner>& runners, const std::string& name) {
    for (const Runner& r : runners)
      if (r.name() == name) return r.seconds();
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// Where problems are rough `klu` tries its pivots again and factorizes anew: the time of both.
  void write(Table& table, Table& best, const mbs::Pattern& pattern, int variables,
             const std::vector<Runner>& runners) {
    const auto cost = mbs::elimination_cost(pattern);
    const double smooth = least(runners, ""), rough = least(runners, "klu");
    const std::string choice = mbs::solver_choice(kind_.kind, pattern),
                      thesis = thesis_choice(kind_.kind, cost.columns, entries_);
    const double full = seconds_of(runners, "klu_full");
    const auto in_all = [&](const std::string& used, double seconds) {
      return used == "klu" ? seconds + full : seconds;
    };
    const auto add = [&](const std::string& name, const std::string& chosen, double seconds) {
      const double where_rough = in_all(chosen.empty() ? name : chosen, seconds);
      table.add({kind_.name, placement_name(), std::to_string(cost.columns), std::to_string(entries_),
                 fmt::format("{:.1f}", pattern.size() / static_cast<double>(cost.columns)),
                 std::to_string(cost.band_width), fmt::format("{:.0f}", cost.entries),
                 fmt::format("{:.0f}", cost.operations), name, chosen, fmt::format("{:.4g}", 1e6 * seconds),
                 fmt::format("{:.2f}", seconds / smooth),
                 std::isfinite(where_rough) ? fmt::format("{:.2f}", where_rough / rough) : ""});
    };
    names_.clear();
    for (const Runner& r : runners) {
      add(r.name(), r.name() == "auto" ? choice : "", r.seconds());
      if (r.seconds() < std::max(slow_solution, hopeless * smooth)) names_.push_back(r.name());
    }
    const double by_thesis = seconds_of(runners, thesis), by_choice = seconds_of(runners, "auto");
    if (std::isfinite(by_thesis)) add("thesis", thesis, by_thesis);
    const auto over = [](double seconds, double least) {
      return std::isfinite(seconds) ? fmt::format("{:.2f}", seconds / least) : "";
    };
    const auto add_best = [&](const char* problem, double least, double chosen, double of_thesis) {
      best.add({kind_.name, placement_name(), problem, std::to_string(variables), std::to_string(entries_),
                best_of(runners, least), over(chosen, least), over(of_thesis, least)});
    };
    add_best("smooth", smooth, by_choice, by_thesis);
    if (kind_.kind != MatrixKind::positive_definite)
      add_best("rough", rough, in_all(choice, by_choice), in_all(thesis, by_thesis));
  }

  const char* placement_name() const { return placement_ == Placement::near ? "near" : "anywhere"; }

  static std::string best_of(const std::vector<Runner>& runners, double seconds) {
    for (const Runner& r : runners)
      if (r.name() != "auto" && r.seconds() == seconds) return r.name();
    return "";
  }

  Kind kind_;
  Placement placement_;
  int entries_;
  std::vector<std::string> names_;
};

}  // namespace

std::vector<Table> linear_solvers() {
  test::add_thesis_solvers();
  Table table({"kind", "placement", "variables", "filling", "entries_a_row", "band_width", "entries_of_l",
               "operations", "solver", "choice", "us", "over_best_smooth", "over_best_rough"});
  Table best({"kind", "placement", "problem", "variables", "filling", "best", "auto", "thesis"}, "best");
  SolverFit fit;
  for (const Kind& kind : kinds)
    for (const Placement placement : {Placement::near, Placement::anywhere})
      for (const int entries : {6, 12, 25, 50, 100}) {
        if (placement == Placement::anywhere && entries == 6) continue;  // there are none to place
        Row row(kind, placement, entries);
        for (const int variables : {10, 20, 50, 100, 200, 500, 1000, 2000, 4000, 8000})
          if (variables >= entries) row.add_size(table, best, fit, variables);
      }
  fit.print();
  return {table, best};
}

}  // namespace tandem::bench
