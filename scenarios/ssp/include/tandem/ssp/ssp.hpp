// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::ssp {

/// A system of the standard System Structure and Parameterization, 1.0 or 2.0 (ssp-standard.org), in the
/// language of scenarios.
struct ScenarioText {
  std::string text;                  ///< TOML
  std::vector<int> lines;            ///< of each line of the text, the line of the system that it stands for
  std::vector<std::string> remarks;  ///< what the standard leaves open, and what has no effect
};

/// Reads a system: its components, which are FMUs, nested systems, connections and parameters. FMUs'
/// descriptions are read, and no library is loaded. Nothing outside an archive is read. Throws Error with file,
/// line and what is allowed.
ScenarioText scenario_text(const std::filesystem::path& file);

}  // namespace tandem::ssp
