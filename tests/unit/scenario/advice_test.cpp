// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scenario/assembly.hpp"
#include "two_mass/masses.hpp"

namespace tandem::scenario {
namespace {

std::vector<std::string> advice_for(const std::string& file, const std::vector<std::string>& overrides) {
  Builtins builtins;
  two_mass::add_builtins(builtins);
  const Scenario scenario = read(std::string(TANDEM_SOURCE_DIR) + "/scenarios/two_mass/" + file, overrides);
  Assembly assembly(scenario, builtins);
  assembly.initialize();
  return advice(assembly.coordinator());
}

TEST(Advice, AForceOfTheLeaderBelongsToTheFollower) {
  EXPECT_EQ(advice_for("force_plain.toml", {}).size(), 0U);
  const auto lines = advice_for("force_plain.toml", {"coordination.schedule=fastest-first"});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("fast.F depends at once on input fast.x2"), std::string::npos) << lines[0];
}

TEST(Advice, InParallelNobodyLeads) {
  EXPECT_EQ(advice_for("force_plain.toml", {"coordination.schedule=parallel"}).size(), 0U);
}

TEST(Advice, WithoutFeedthroughThereIsNone) {
  EXPECT_EQ(advice_for("two_mass.toml", {"coordination.schedule=fastest-first"}).size(), 0U);
}

}  // namespace
}  // namespace tandem::scenario
