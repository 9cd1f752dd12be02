// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tandem/transports/parameters.hpp"

namespace tandem::exported {

/// Who integrates: the FMU, or its importer.
enum class Interface { co_simulation, model_exchange };

/// What an FMU runs, as its resources say: a file beside the files of the source.
struct Manifest {
  std::string token;                                    ///< guid (2.0), instantiationToken (3.0)
  std::string source;                                   ///< "diagram:files/engine.toml"
  std::vector<std::string> overrides = {};              ///< "KEY=VALUE" of its file
  std::map<std::string, Parameters::Value> parameters;  ///< of the source, as it was exported with
  std::map<std::string, double> starts = {};            ///< of inputs by name, in their units
  Interface interface = Interface::co_simulation;

  const char* interface_name() const {
    return interface == Interface::model_exchange ? "Model Exchange" : "Co-Simulation";
  }
};

inline constexpr const char* manifest_name = "tandem.toml";

std::string written(const Manifest& manifest);
/// Throws Error with file, line, the value found and what is allowed.
Manifest read_manifest(const std::filesystem::path& file);

}  // namespace tandem::exported
