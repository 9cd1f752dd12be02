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
struct Model {
  MatrixKind kind;
  const char* solver;
  Shape shape;
  double start, row, entry, operation;
};

using enum MatrixKind;
using enum Shape;
constexpr Model models[] = {
    {positive_definite, "band", band, 1, 1, 1, 1},
    {symmetric, "klu", sparse, 1, 1, 1, 1},
    {unsymmetric, "klu", sparse, 1, 1, 1, 1},
};

double expected(const Model& m, const EliminationCost& cost) {
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
  const Model* best = nullptr;
  for (const Model& m : models)
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
  void solve(double* b) override { solver_->solve(b); }

 private:
  MatrixKind kind_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace

std::unique_ptr<LinearSolver> automatic(MatrixKind kind) { return std::make_unique<Auto>(kind); }

}  // namespace solvers
}  // namespace tandem::mbs
