// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The first scene of two physics: the linkage driven by the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::engine_linkage_tests {
namespace {

using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string scene = TANDEM_SOURCE_DIR "/scenarios/engine_linkage/";

/// The speeds printed in the specification of the scene.
TEST(EngineLinkage, TheOneDegreeOfFreedomRunsAtThePrintedSpeeds) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", scene + "exact.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table = text::TimeTable::read(folder.path() / "o");
  const double times[] = {1.9, 8.9, 13.9, 19.9, 24.9, 29.9};
  const double printed[] = {28.0, 16.6, 35.4, 12.4, 24.8, 10.2};
  for (std::size_t k = 0; k < std::size(times); ++k) {
    const auto row = std::lower_bound(table.times.begin(), table.times.end(), times[k] - 1e-6);
    EXPECT_NEAR(*row, times[k], 1e-6);
    EXPECT_NEAR(table.columns[0][static_cast<std::size_t>(row - table.times.begin())], printed[k], 0.1) << k;
  }
}

std::string row_of(const std::string& table, const std::string& begin) {
  const auto at = table.find('\n' + begin) + 1;
  return table.substr(at, table.find('\n', at) - at);
}

/// The goal of the scene: within 0.05 rad/s with ten steps of the engine in one of the linkage, for 30 s.
/// Each of these passes some 180 flat positions with a torque that jumps.
TEST(EngineLinkage, StaysNearTheTruthAtAStepRatioOfTen) {
  const Scratch folder;
  const std::string where =
      "step_ratio == 10 && ((schedule is slowest-first) && (to_fast is hermite) && (to_slow is lagrange1) || "
      "(schedule is parallel) && (to_fast is lagrange0))";
  const Said said = tandem(
      folder, {"sweep", scene + "study.toml", "--table", "schemes", "--where", where, "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const std::string table = read_text(folder.path() / "o/schemes.csv");
  for (const char* scheme : {"slowest-first,hermite,lagrange1,", "parallel,lagrange0,lagrange0,"}) {
    const std::string row = row_of(table, scheme);
    double largest = 1.0, rms = 1.0, exchanges = 0.0;
    ASSERT_EQ(std::sscanf(row.c_str() + std::string(scheme).size(), "0.0001,10,%lf,%lf,%lf,ok", &largest,
                          &rms, &exchanges),
              3)
        << row;
    EXPECT_LT(largest, 0.05) << row;
    EXPECT_LE(rms, largest);
    EXPECT_GE(exchanges, 60000 - 10);
  }
}

TEST(EngineLinkage, OneLoopIsTheMechanismOfTheScenario) {
  const Scratch folder;
  const auto results = [&](const std::string& source) {
    const Said said = tandem(folder, {"run", scene + "engine_linkage.toml", "--set", "span.stop=0.5", "--set",
                                      "subsystems.linkage.source=" + source, "--output", "o"});
    EXPECT_EQ(said.status, 0) << said.err;
    return read_text(folder.path() / "o/results.csv");
  };
  EXPECT_EQ(results("builtin:engine_linkage.linkage"), results("mechanism:linkage.toml"));
  EXPECT_NE(results("builtin:engine_linkage.linkage?loops=2"), results("mechanism:linkage.toml"));
  const Said said = tandem(folder, {"info", "builtin:engine_linkage.linkage?loops=1.5&step=1e-3"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("parameter 'loops' is 1.5; allowed are 1, 2, ... 1000000"), std::string::npos)
      << said.err;
}

}  // namespace
}  // namespace tandem::engine_linkage_tests
