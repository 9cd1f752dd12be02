// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "elimination.hpp"
#include "order.hpp"
#include "solvers.hpp"
#include "tandem/mbs/sparse/solver_choice.hpp"

namespace tandem::mbs {
namespace {

enum class Shape { sparse, band, dense };

/// Time of a factorization and two solutions [ns], as `tandem bench solvers` fits it:
///   sparse: start + row n + entry |L| + operation ops;  band: start + row n + entry n w + operation n w^2;
///   dense: start + row n + entry n^2 + operation n^3.
/// Solvers that are nowhere the best, or by little, are not here. Of symmetric matrices it is the fit of an
/// earlier run: a later one takes klu where its pivots fill in more than the model knows (docs/sparse.md).
struct TimeModel {
  MatrixKind kind;
  Shape shape;
  const char* solver;
  double start, row, entry, operation;
};

using enum MatrixKind;
using enum Shape;
constexpr TimeModel time_models[] = {
    {positive_definite, band, "band", 0, 0, 3.189, 0.04532},
    {positive_definite, sparse, "prepared", 0, 16.74, 5.176, 0.1732},
    {positive_definite, band, "lapack_band", 142.2, 58.84, 4.721, 0.004743},
    {positive_definite, dense, "lapack", 993.8, 13.33, 2.786, 0.008253},
    {symmetric, sparse, "klu", 0, 0, 20.49, 4.969},
    {symmetric, dense, "eigen_dense", 0, 12.75, 6.896, 0.04681},
    {symmetric, band, "lapack_band", 0, 90.99, 16.65, 0.02241},
    {symmetric, dense, "lapack", 0, 108, 6.122, 0.01047},
    {unsymmetric, sparse, "klu", 0, 25.71, 11.7, 1.329},
    {unsymmetric, dense, "eigen_dense", 108.2, 0, 4.966, 0.02484},
    {unsymmetric, band, "lapack_band", 0, 75.24, 8.329, 0.01313},
    {unsymmetric, dense, "lapack_lu", 431.7, 9.345, 4.434, 0.01386},
};

double expected(const TimeModel& m, const EliminationCost& cost) {
  const double n = cost.columns, w = cost.band_width;
  switch (m.shape) {
    case sparse:
      return m.start + m.row * n + m.entry * cost.entries + m.operation * cost.operations;
    case band:
      return m.start + m.row * n + m.entry * n * w + m.operation * n * w * w;
    default:
      return m.start + m.row * n + m.entry * n * n + m.operation * n * n * n;
  }
}

}  // namespace

EliminationCost elimination_cost(const Pattern& pattern) {
  const auto elimination = solvers::eliminate(pattern, solvers::minimum_degree_order(pattern), 1);
  EliminationCost cost{pattern.columns(), solvers::band_width(pattern, solvers::narrow_order(pattern)), 0.0,
                       solvers::operations(elimination)};
  for (const auto& supernode : elimination.supernodes)
    cost.entries += static_cast<double>(supernode.rows.size());
  return cost;
}

std::string solver_choice(MatrixKind kind, const Pattern& pattern) {
  const EliminationCost cost = elimination_cost(pattern);
  const auto there = solver_names(kind);
  const TimeModel* best = nullptr;
  for (const TimeModel& m : time_models)
    if (m.kind == kind && std::find(there.begin(), there.end(), m.solver) != there.end())
      if (!best || expected(m, cost) < expected(*best, cost)) best = &m;
  return best->solver;
}

namespace solvers {
namespace {

class Auto final : public LinearSolver {
 public:
  explicit Auto(MatrixKind kind) : kind_(kind) {}
  void analyze(const Pattern& pattern) override {
    solver_ = make_solver(solver_choice(kind_, pattern), kind_);
    solver_->analyze(pattern);
  }
  Layout layout() const override { return solver_->layout(); }
  int factorize(double* values) override { return solver_->factorize(values); }
  bool in_place() const override { return solver_->in_place(); }
  void solve(double* b) override { solver_->solve(b); }
  void remember(std::vector<double>& to) const override { solver_->remember(to); }
  void recall(std::span<const double> memory) override { solver_->recall(memory); }

 private:
  MatrixKind kind_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace

std::unique_ptr<LinearSolver> automatic(MatrixKind kind) { return std::make_unique<Auto>(kind); }

}  // namespace solvers
}  // namespace tandem::mbs
