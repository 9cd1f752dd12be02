// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/text/set_value.hpp"

namespace tandem::scenario {

/// A value of a scenario by its path, "coordination.schedule".
struct Setting {
  std::string key;
  text::SetValue value;
};

/// A scenario file, of which the text is read once, and the scenario again and again, each time with other
/// values. It is parsed once for each list of keys that are set.
class ScenarioFile {
 public:
  /// Throws Error for a file that can't be read or is no TOML, and for an override that can't be put in.
  explicit ScenarioFile(std::filesystem::path file, std::vector<std::string> overrides = {});
  ~ScenarioFile();
  ScenarioFile(const ScenarioFile&) = delete;
  ScenarioFile& operator=(const ScenarioFile&) = delete;

  /// From any thread. Throws as read() does.
  Scenario with(const std::vector<Setting>& settings) const;

 private:
  class Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace tandem::scenario
