// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace tandem::mbs {

/// Units next to each other that are alike, columns of a matrix or blocks of its rows: what loops over them
/// go by, so that they ask for the numbers once a run.
struct Run {
  int groups;    ///< of a unit
  int together;  ///< values of a group: 2 or 3 where they stand in rows without a gap, else 1
  int units;
  int unit = 0, row = 0, group = 0, value = 0;  ///< how many there are before it, a row for each `together`
  bool operator==(const Run&) const = default;
};

/// Another unit at the end.
inline void append(std::vector<Run>& runs, int groups, int together) {
  if (!runs.empty() && runs.back().groups == groups && runs.back().together == together) {
    ++runs.back().units;
    return;
  }
  Run next{groups, together, 1};
  if (!runs.empty()) {
    const Run& last = runs.back();
    next.unit = last.unit + last.units;
    next.row = last.row + last.units * last.together;
    next.group = last.group + last.units * last.groups;
    next.value = last.value + last.units * last.groups * last.together;
  }
  runs.push_back(next);
}

}  // namespace tandem::mbs
