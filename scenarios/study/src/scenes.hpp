// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "tandem/study/study.hpp"

namespace tandem::study {

/// The scenarios of a study, of which each file is read once.
class Scenes {
 public:
  Scenes(const Study& study, std::vector<std::string> overrides)
      : study_(study), overrides_(std::move(overrides)) {}

  // From any thread. Throw Error for values that the scenario does not take.
  scenario::Scenario of_row(const FileValues& row);
  /// per: the values that it goes by. columns: those of the rows that need it.
  scenario::Scenario of_reference(const Reference& reference, const FileValues& per,
                                  const std::vector<std::string>& columns);

 private:
  const scenario::ScenarioFile& file(const Given& name, const FileValues& values);

  const Study& study_;
  std::vector<std::string> overrides_;
  std::mutex mutex_;
  std::map<std::filesystem::path, std::unique_ptr<scenario::ScenarioFile>> files_;
};

}  // namespace tandem::study
