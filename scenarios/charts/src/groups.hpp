// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace tandem::charts {

/// Words in the order in which they come, each once.
class Groups {
 public:
  /// The number of a word, which is added if it is new.
  std::size_t of(const std::string& word) {
    const auto it = std::find(names_.begin(), names_.end(), word);
    if (it != names_.end()) return static_cast<std::size_t>(it - names_.begin());
    names_.push_back(word);
    return names_.size() - 1;
  }
  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }

 private:
  std::vector<std::string> names_;
};

}  // namespace tandem::charts
