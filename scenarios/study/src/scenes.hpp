// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "scaled_steps.hpp"
#include "tandem/scenario/scenario_file.hpp"
#include "tandem/study/study.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// The scenarios of a study, of which each file is read once.
class Scenes {
 public:
  Scenes(const Study& study, const Builtins& builtins, std::vector<std::string> overrides)
      : study_(study), builtins_(builtins), overrides_(std::move(overrides)), scaled_(builtins) {}

  // From any thread. Throw Error for values that the scenario does not take.
  /// Its own steps are those of the scenario.
  scenario::Scenario of_row(const Table& table, const FileValues& row);
  /// As the study's `steps` says. Throws Error for a scenario that can't be opened too.
  void scale_steps(scenario::Scenario& scenario, const FileValues& values);
  /// per: the values that it goes by. columns: those of the rows that need it.
  scenario::Scenario of_reference(const Reference& reference, const Table& table, const FileValues& per,
                                  const std::vector<std::string>& columns);

  /// The keys that it sets.
  std::vector<Given> set_of(const Reference& reference, const Table& table,
                            const std::vector<std::string>& columns) const;

 private:
  const Given& name_of(const Table& table) const {
    return table.scenario ? *table.scenario : study_.scenario;
  }
  std::vector<Given> set_in(const Table& table) const;
  const scenario::ScenarioFile& file(const Given& name, const FileValues& values);

  const Study& study_;
  const Builtins& builtins_;
  std::vector<std::string> overrides_;
  ScaledSteps scaled_;
  std::mutex mutex_;
  std::map<std::filesystem::path, std::unique_ptr<scenario::ScenarioFile>> files_;
};

}  // namespace tandem::study
