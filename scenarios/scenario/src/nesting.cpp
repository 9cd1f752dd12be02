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

struct Size {
  long subsystems;
  int levels;
};

void refuse_beyond(const SubsystemEntry& entry, const Size& sum) {
  if (sum.levels > deepest)
    refuse(entry.source_place,
           fmt::format("subsystem '{}' is a scenario with others in it, {} deep in all; allowed are {}",
                       entry.name, sum.levels, deepest));
  if (sum.subsystems > most_subsystems)
    refuse(
        entry.source_place,
        fmt::format(
            "scenario '{}' has more than {} subsystems with those of the scenarios in it; allowed are up to "
            "that",
            entry.place.file, most_subsystems));
}

/// Counts each file once, however often it is named.
class Nesting {
 public:
  Size size(const Scenario& scenario) {
    const fs::path file = fs::weakly_canonical(scenario.file);
    sizes_[file] = under_way;
    Size sum{0, 1};
    for (const SubsystemEntry& entry : scenario.subsystems) {
      const Size one = entry.scheme() == nested_scheme ? size(entry) : Size{1, 0};
      sum = {sum.subsystems + one.subsystems, std::max(sum.levels, one.levels + 1)};
      refuse_beyond(entry, sum);
    }
    return sizes_[file] = sum;
  }

 private:
  static constexpr Size under_way{-1, 0};

  Size size(const SubsystemEntry& entry) {
    const auto known = sizes_.find(fs::weakly_canonical(entry.file()));
    if (known == sizes_.end()) return size(scenario::read(entry.file()));
    if (known->second.subsystems == under_way.subsystems)
      refuse(entry.source_place, fmt::format("subsystem '{}' is scenario '{}', which it stands in itself",
                                             entry.name, entry.file().string()));
    return known->second;
  }

  std::map<fs::path, Size> sizes_;
};

}  // namespace

void check_nesting(const Scenario& scenario) { Nesting().size(scenario); }

}  // namespace tandem::scenario
