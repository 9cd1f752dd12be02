// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/run_matrices.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "tandem/error.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::cli {

namespace fs = std::filesystem;
using scenario::Scenario;

namespace {

void check_times(const std::string& times, const Scenario& scenario) {
  for (const double t : matrix_times("--dump-at", times))
    if (!(t >= scenario.start && t <= scenario.stop))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("--dump-at: {} s is outside the run; allowed is {} to {} s", t, scenario.start,
                              scenario.stop));
}

}  // namespace

Scenario with_matrices(Scenario scenario, const Matrices& matrices, const Builtins& builtins) {
  if (!matrices.folder) return scenario;
  if (matrices.folder->empty())
    throw Error(ErrorCode::invalid_argument, "--dump-matrices is ''; allowed is the name of a folder");
  if (matrices.times) check_times(*matrices.times, scenario);
  bool found = false;
  for (auto& entry : scenario.subsystems) {
    if (!scenario::takes(entry, builtins, "matrices")) continue;
    found = true;
    if (entry.name.find('/') != std::string::npos || entry.name.starts_with("."))
      scenario::refuse(entry.place, "subsystem '" + entry.name +
                                        "' gives its name to a folder of matrices; allowed is one without / "
                                        "and a dot at its beginning");
    const auto set = [&](const char* name, const std::string& value) {
      entry.parameters.push_back({name, value, entry.place});
    };
    set("matrices", fs::absolute(fs::path(*matrices.folder) / entry.name).string());
    if (matrices.times) set("matrices_at", *matrices.times);
    set("matrices_format", matrices.format);
  }
  if (!found)
    throw Error(ErrorCode::invalid_argument,
                "--dump-matrices: no subsystem of the scenario has the source "
                "mechanism:FILE, so there are no matrices");
  return scenario;
}

}  // namespace tandem::cli
