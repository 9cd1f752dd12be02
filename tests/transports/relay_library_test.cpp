// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A relay in C, the example of a subsystem with events.
#include <gtest/gtest.h>

#include "c_oscillator.h"
#include "run_bench.hpp"
#include "served.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/check.hpp"

namespace tandem::test {
namespace {

std::unique_ptr<Subsystem> relay() {
  return open("lib:" TANDEM_EXAMPLES "/example_relay_c.so?high=0.3&low=-0.2&on=-1&off=1&h=0.07",
              all_sources());
}

TEST(RelayLibrary, KeepsWhatASubsystemWithEventsPromises) {
  for (const Finding& finding : check(relay))
    EXPECT_EQ(finding.kind, Finding::Kind::left_out) << finding.check << ": " << finding.sentence;
}

/// Both rows of a switching, and one of the plant there, which is at the threshold but for what a cubic errs.
TEST(RelayLibrary, SwitchesWhereItsInputPassesAThreshold) {
  CSubsystem plant(c_oscillator(), "h=0.02");
  const auto switching = relay();
  RunBench bench;
  bench.add("plant", plant).add("relay", *switching).schedule("slowest-first");
  bench.connect("plant.x", "relay.x", "lagrange3").connect("relay.F", "plant.F", "");
  bench.coordination.order = {"plant", "relay"};
  const auto rows = bench.run(10.0).all();
  int events = 0;
  for (std::size_t k = 1; k < rows[1].size(); ++k) {
    if (rows[1][k][2] == rows[1][k - 1][2]) continue;
    const double t = rows[1][k][0];
    EXPECT_EQ(rows[1][k - 1][0], t);
    const auto at =
        std::find_if(rows[0].begin(), rows[0].end(), [t](const auto& row) { return row[0] == t; });
    ASSERT_NE(at, rows[0].end()) << t;
    EXPECT_NEAR((*at)[2], rows[1][k][2] < 0.0 ? 0.3 : -0.2, 1e-5) << t;
    ++events;
  }
  EXPECT_GE(events, 4);
}

}  // namespace
}  // namespace tandem::test
