// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tandem/coordinator/recorder.hpp"
#include "tandem/scenario/comparison.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// The reference that a scenario names, and what a run's results differ from it.
class RunReference {
 public:
  /// Reads it. Throws Error for one that the results that are recorded can't be compared with.
  RunReference(const Scenario& scenario, const Recorder& recorder);

  /// Of the results in that folder.
  void compare(const std::filesystem::path& folder);
  /// For results.json: its file, whether all is within the tolerances, the differences.
  nlohmann::ordered_json figures() const;
  /// "compared with FILE", and a line a column; empty before compare().
  std::string report() const;
  /// What is not within the tolerances, in sentences.
  const std::vector<std::string>& outside() const { return outside_; }

 private:
  void check_judged(const Recorder& recorder) const;
  /// By the reference each column, and the judged quantity by [judge], too. Of both the one that is not met is told.
  void judge(const Difference& difference, double tolerance, Norm norm);

  const Scenario& scenario_;
  text::TimeTable table_;
  std::string report_;
  nlohmann::ordered_json differences_ = nlohmann::ordered_json::object();
  std::vector<std::string> outside_;
};

}  // namespace tandem::scenario
