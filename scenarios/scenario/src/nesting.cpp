// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "nesting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.hpp"

namespace tandem::scenario {
namespace {

namespace fs = std::filesystem;

constexpr long most_subsystems = 10000;
constexpr int deepest = 4;

/// Counts each file once, however often it is named.
class Nesting {
 public:
  struct Size {
    long subsystems;
    int levels;
  };

  Size size(const Scenario& scenario) {
    const fs::path file = fs::weakly_canonical(scenario.file);
    sizes_[file] = under_way;
    Size sum{0, 1};
    for (const SubsystemEntry& entry : scenario.subsystems) {
      const Size one = scheme_of(entry) == nested_scheme ? size(entry) : Size{1, 0};
      sum = {sum.subsystems + one.subsystems, std::max(sum.levels, one.levels + 1)};
      if (sum.levels > deepest)
        refuse(entry.source_place,
               fmt::format("subsystem '{}' is a scenario with others in it, {} deep in all; allowed "
                           "are {}",
                           entry.name, sum.levels, deepest));
      if (sum.subsystems > most_subsystems)
        refuse(entry.source_place,
               fmt::format(
                   "scenario '{}' has more than {} subsystems with those of the scenarios in it; allowed are "
                   "up to that",
                   scenario.file.string(), most_subsystems));
    }
    return sizes_[file] = sum;
  }

 private:
  static constexpr Size under_way{-1, 0};

  Size size(const SubsystemEntry& entry) {
    const auto known = sizes_.find(fs::weakly_canonical(file_of(entry)));
    if (known == sizes_.end()) return size(scenario::read(file_of(entry)));
    if (known->second.subsystems == under_way.subsystems)
      refuse(entry.source_place, fmt::format("subsystem '{}' is scenario '{}', which it stands in itself",
                                             entry.name, file_of(entry).string()));
    return known->second;
  }

  std::map<fs::path, Size> sizes_;
};

}  // namespace

std::string scheme_of(const SubsystemEntry& entry) { return entry.source.substr(0, entry.source.find(':')); }

fs::path file_of(const SubsystemEntry& entry) {
  const std::string place = entry.source.substr(entry.source.find(':') + 1);
  return fs::path(entry.place.file).parent_path() / place.substr(0, place.find('?'));
}

void check_nesting(const Scenario& scenario) { Nesting().size(scenario); }

}  // namespace tandem::scenario
