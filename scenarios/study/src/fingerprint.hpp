// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <set>
#include <string>

#include "tandem/scenario/scenario.hpp"

namespace tandem::study {

/// A checksum of all that rows are made from: files, those that a scenario names in any text of it (and those
/// that TOML files among them name), what the command line sets, the seed of what is drawn, and this program.
class Fingerprint {
 public:
  void add(const std::filesystem::path& file);
  void add(const scenario::Scenario& scenario);
  /// 16 digits.
  std::string text(const std::vector<std::string>& overrides, std::uint64_t seed) const;

 private:
  void add_named(const std::string& text, const std::filesystem::path& folder);

  std::set<std::filesystem::path> files_;
  std::set<std::string> seen_;  ///< texts, each with the folder that it is of
};

}  // namespace tandem::study
