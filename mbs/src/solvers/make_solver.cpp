// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <functional>

#include "check_memory.hpp"
#include "solvers.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

using solvers::SolverEntry;

/// Every solver of this build, and those that were added.
std::vector<SolverEntry>& entries() {
  static std::vector<SolverEntry> all = [] {
    using enum MatrixKind;
    std::vector<SolverEntry> list = {{"auto", unsymmetric, solvers::automatic}};
    const auto of_libraries = solvers::library_solvers();
    list.insert(list.end(), of_libraries.begin(), of_libraries.end());
    list.insert(list.end(), {{"eigen_dense", unsymmetric, solvers::eigen_dense},
                             {"prepared", positive_definite, solvers::prepared},
                             {"band", positive_definite, solvers::band}});
    return list;
  }();
  return all;
}

}  // namespace

void LinearSolver::recall(std::span<const double> memory) { check_memory(memory.empty()); }

void add_solver(const std::string& name, MatrixKind worst, MakeSolver* make) {
  for (const SolverEntry& entry : entries())
    if (entry.name == name)
      throw Error(ErrorCode::invalid_argument,
                  "there is a linear solver '" + name + "'; allowed is another name");
  entries().push_back({name, worst, make});
}

std::vector<std::string> solver_names(MatrixKind kind) {
  std::vector<std::string> names;
  for (const SolverEntry& entry : entries())
    if (entry.worst >= kind) names.push_back(entry.name);
  return names;
}

std::unique_ptr<LinearSolver> make_solver(const std::string& name, MatrixKind kind) {
  for (const SolverEntry& entry : entries())
    if (entry.name == name && entry.worst >= kind) return entry.make(kind);
  constexpr const char* kinds[] = {"positive definite", "symmetric", "unsymmetric"};
  throw Error(ErrorCode::invalid_argument,
              unknown(fmt::format("solver for {} matrices", kinds[static_cast<int>(kind)]), name,
                      solver_names(kind)));
}

}  // namespace tandem::mbs
