// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "command.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::test {

inline const std::string kart_folder = std::string(TANDEM_SOURCE_DIR) + "/scenarios/kart/";

/// What `tandem run` says of a scenario, and what it writes.
class SceneRun {
 public:
  explicit SceneRun(const std::string& file, const std::vector<std::string>& settings = {}) {
    std::vector<std::string> words = {"run", file, "--output", "o"};
    for (const std::string& s : settings) words.insert(words.end(), {"--set", s});
    said_ = tandem(folder_, words);
    table_ = text::TimeTable::read(folder_.path() / "o");
  }
  const Said& said() const { return said_; }
  const std::vector<double>& column(const std::string& name) const {
    const auto at = std::find(table_.names.begin(), table_.names.end(), name) - table_.names.begin();
    return table_.columns.at(static_cast<std::size_t>(at));
  }
  const std::vector<double>& times() const { return table_.times; }
  double last(const std::string& name) const { return column(name).back(); }

 private:
  Scratch folder_;
  Said said_;
  text::TimeTable table_;
};

}  // namespace tandem::test
