// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem::test {

/// A schedule and the reconstructions both ways.
struct Scheme {
  std::string schedule, to_fast, to_slow;
  std::string name() const { return schedule + " " + to_fast + " " + to_slow; }
};

/// Every schedule with every kind of reconstruction that it can honour.
inline std::vector<Scheme> all_schemes() {
  std::vector<Scheme> schemes = {{"staggered", "matched_hold", "matched_hold"},
                                 {"slowest-first", "mean", "lagrange3"},
                                 {"fastest-first", "lagrange3", "mean"}};
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* how :
         {"lagrange0", "lagrange1", "lagrange2", "lagrange3", "lagrange4", "hermite", "least_squares0_1",
          "least_squares1_2", "least_squares2_4", "least_squares4_16", "matched_hold"})
      if (std::string(schedule) != "parallel" || std::string(how) != "matched_hold")
        schemes.push_back({schedule, how, how});
  return schemes;
}

}  // namespace tandem::test
