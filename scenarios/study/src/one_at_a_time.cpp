// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "one_at_a_time.hpp"

#include "tandem/error.hpp"
#include "tandem/scenario/parts.hpp"

namespace tandem::study {
namespace {

/// Empty for a row that can't be opened: it tells why itself.
std::string once_per_process(const Table& table, Scenes& scenes, const Builtins& builtins) {
  try {
    return scenario::once_per_process(scenes.of_row(table, table.rows.front()), builtins);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

std::string one_at_a_time(const Study& study, Scenes& scenes, const Builtins& builtins) {
  for (const Table& table : study.tables) {
    const std::string name = table.rows.empty() ? "" : once_per_process(table, scenes, builtins);
    if (!name.empty())
      return "subsystem '" + name +
             "' may be there once in a process (canBeInstantiatedOnlyOncePerProcess), so rows run one at a "
             "time; with "
             "'isolate = true' several would";
  }
  return {};
}

}  // namespace tandem::study
