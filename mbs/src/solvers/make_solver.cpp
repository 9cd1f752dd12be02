// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <functional>

#include "solvers.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

struct Entry {
  std::string name;
  MatrixKind kind;  ///< the worst that it takes
  std::unique_ptr<LinearSolver> (*make)(MatrixKind);
};

/// Every solver of this build.
const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {{"klu", MatrixKind::unsymmetric, solvers::klu},
                                         {"ldlt", MatrixKind::positive_definite, solvers::ldlt},
                                         {"prepared", MatrixKind::positive_definite, solvers::prepared},
                                         {"band", MatrixKind::positive_definite, solvers::band}};
  return all;
}

}  // namespace

std::vector<std::string> solver_names(MatrixKind kind) {
  std::vector<std::string> names;
  for (const Entry& entry : entries())
    if (entry.kind >= kind) names.push_back(entry.name);
  return names;
}

std::unique_ptr<LinearSolver> make_solver(const std::string& name, MatrixKind kind) {
  for (const Entry& entry : entries())
    if (entry.name == name && entry.kind >= kind) return entry.make(kind);
  throw Error(ErrorCode::invalid_argument, unknown("solver", name, solver_names(kind)));
}

}  // namespace tandem::mbs
