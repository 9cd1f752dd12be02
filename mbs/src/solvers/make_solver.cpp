// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <functional>

#include "check_memory.hpp"
#include "solvers.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

struct Entry {
  std::string name;
  MatrixKind kind;  ///< the worst that it takes
  MakeSolver* make;
};

/// Every solver of this build, and those that were added.
std::vector<Entry>& entries() {
  using enum MatrixKind;
  static std::vector<Entry> all = {{"auto", unsymmetric, solvers::automatic},
                                   {"klu", unsymmetric, solvers::klu},
                                   {"klu_full", unsymmetric, solvers::klu_full},
#ifdef TANDEM_HAS_LAPACK
                                   {"lapack", symmetric, solvers::lapack},
                                   {"lapack_lu", unsymmetric, solvers::lapack_lu},
                                   {"lapack_band", unsymmetric, solvers::lapack_band},
#endif
                                   {"eigen_dense", unsymmetric, solvers::eigen_dense},
                                   {"prepared", positive_definite, solvers::prepared},
                                   {"band", positive_definite, solvers::band}};
  return all;
}

}  // namespace

void LinearSolver::recall(std::span<const double> memory) { check_memory(memory.empty()); }

void add_solver(const std::string& name, MatrixKind worst, MakeSolver* make) {
  for (const Entry& entry : entries())
    if (entry.name == name)
      throw Error(ErrorCode::invalid_argument,
                  "there is a linear solver '" + name + "'; allowed is another name");
  entries().push_back({name, worst, make});
}

std::vector<std::string> solver_names(MatrixKind kind) {
  std::vector<std::string> names;
  for (const Entry& entry : entries())
    if (entry.kind >= kind) names.push_back(entry.name);
  return names;
}

std::unique_ptr<LinearSolver> make_solver(const std::string& name, MatrixKind kind) {
  for (const Entry& entry : entries())
    if (entry.name == name && entry.kind >= kind) return entry.make(kind);
  constexpr const char* kinds[] = {"positive definite", "symmetric", "unsymmetric"};
  throw Error(ErrorCode::invalid_argument,
              unknown(fmt::format("solver for {} matrices", kinds[static_cast<int>(kind)]), name,
                      solver_names(kind)));
}

}  // namespace tandem::mbs
