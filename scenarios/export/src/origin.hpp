// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tandem/export/export.hpp"
#include "tandem/time_grid.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::exported {

/// The source of an export.
struct Origin {
  std::string scheme;  ///< mechanism, diagram, scenario
  std::filesystem::path file;
  std::vector<std::string> overrides;
  std::map<std::string, Parameters::Value> parameters;  ///< of its table [run], and of the URI in their place
  std::map<std::string, double> starts = {};            ///< its inputs at the start
  std::optional<TimeSpan> span = {};                    ///< of its table [run]
  std::string name = {}, description = {};

  std::string uri() const { return scheme + ":" + file.string(); }
  Opening opening() const;
};

/// Of the file that the settings name, as they say.
Origin read_origin(const ExportSettings& settings);

/// The files that the origin is made of, with each word that its file allows for a parameter, one at a time.
/// Throws Error that names what only this program has.
std::vector<std::filesystem::path> files_of(const Origin& origin, const Builtins& here);

}  // namespace tandem::exported
