// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/fmi/description.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::exported {

struct SystemSettings {
  std::filesystem::path scenario;
  std::vector<std::string> overrides = {};  ///< "KEY=VALUE" of the scenario
  std::filesystem::path file;               ///< the archive to be written, *.ssp
  fmi::Version version = fmi::Version::two;
  std::filesystem::path library;  ///< see ExportSettings
};

/// Writes a scenario as a system of SSP 1.0 (docs/ssp.md): each mechanism and diagram becomes an FMU, FMUs go
/// along as they are, and an annotation keeps what the standard has no words for. Before it is written it is
/// read back and its connections are checked.
/// - here: what this program can open.
/// Returns what it is, a line for each fact. Throws Error that names what can't go along, and as export_fmu().
std::vector<std::string> export_system(const SystemSettings& settings, const Builtins& here);

}  // namespace tandem::exported
