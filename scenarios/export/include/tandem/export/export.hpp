// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tandem/exported/manifest.hpp"
#include "tandem/fmi/description.hpp"
#include "tandem/time_grid.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::exported {

/// What a scenario gives one of its subsystems, in place of the table [run] of its file.
struct Member {
  std::map<std::string, Parameters::Value> parameters;
  std::map<std::string, double> starts;  ///< its inputs at the start
  TimeSpan span;
};

struct ExportSettings {
  /// The file of a mechanism, a diagram or a scenario of these, or "mechanism:FILE?KEY=VALUE&..",
  /// "diagram:FILE?..", "scenario:FILE?.."
  std::string source;
  std::vector<std::string> overrides = {};  ///< "KEY=VALUE" of the file
  std::filesystem::path file;               ///< the FMU to be written
  fmi::Version version = fmi::Version::two;
  /// The folder of the library that FMUs bring (the target tandem_fmu).
  std::filesystem::path library;
  std::optional<Member> member = {};
  Interface interface = Interface::co_simulation;  ///< Model Exchange of a diagram alone
};

/// Writes an FMU that needs nothing else: the library, the source's files and all that they
/// name, the description, documentation. The same source gives the same bytes. Before it is written it is
/// opened and started from what will be in it.
/// - here: what this program can open, to tell what an FMU can't take along.
/// Returns what it is, a line for each fact. Throws Error for a source that can't be exported, and as the
/// source and its files do.
std::vector<std::string> export_fmu(const ExportSettings& settings, const Builtins& here);

}  // namespace tandem::exported
