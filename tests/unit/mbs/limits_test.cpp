// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Limits of a mechanism's signals: reading, telling, ending.
#include "tandem/mbs/mechanism/limits.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

/// A mass at height 1 m that the air holds; the limit stands in line 11.
std::string falling(const std::string& limit) {
  return "name = 'm'\ndimension = 2\n[points]\nP = { at = [0, 1] }\n[masses]\nmass = { point = 'P', mass = 1 "
         "}\n"
         "[elements]\nair = { kind = 'drag', point = 'P', coefficient = 0.5 }\n[outputs]\n"
         "height = { position = 'P.y' }\n[limits]\nlow = { " +
         limit + " }\n";
}

/// What is told where the mass stands at these heights, a second apart, and falls at 2 m/s.
std::vector<std::string> told(const std::string& limit, const std::vector<double>& heights) {
  std::vector<std::string> all;
  Mechanism m(read_mechanism("m", falling(limit)));
  Limits limits(m, [&](const std::string& text) { all.push_back(text); });
  State s = initial_state(m, 0.0);
  limits.start(s);
  for (const double height : heights) {
    s.q[1] = height, s.v[1] = -2.0;
    limits.look(s);
    s.time += 1.0;
  }
  return all;
}

TEST(Limits, ASignalThatLeavesThemIsToldOnceWithItsValue) {
  const auto all =
      told("signal = 'height', low = 0.5, high = 3, sentence = 'why'", {1.0, 0.25, 0.1, 1.0, 0.2});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0], "limit 'low': signal 'height' is 0.25 m, below 0.5, from t = 1 s on: why");
}

/// 0.5 N s^2/m^2 x (2 m/s)^3 W are lost.
TEST(Limits, AnElementsQuantityIsASignal) {
  const auto all =
      told("signal = { element = 'air', quantity = 'power' }, high = -5, sentence = 'why'", {1.0});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0], "limit 'low': power of element 'air' is -4 W, above -5, from t = 0 s on: why");
}

TEST(Limits, OneThatStopsEndsWithItsSentence) {
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"0.25 m, below 0.5, from t = 1 s on: why"}, [] {
    told("signal = 'height', low = 0.5, on_leaving = 'stop', sentence = 'why'", {1.0, 0.25});
  }));
}

TEST(Limits, OneThatIsIgnoredTellsNothing) {
  EXPECT_TRUE(told("signal = 'height', low = 0.5, on_leaving = 'ignore', sentence = 'why'", {0.1}).empty());
}

TEST(Limits, WhatIsWrongIsRefusedWithItsLine) {
  const auto refused = [](const std::string& limit, std::vector<std::string> texts) {
    texts.emplace_back("m:12");
    return refuses(ErrorCode::invalid_argument, texts, [&] { read_mechanism("m", falling(limit)); });
  };
  EXPECT_TRUE(refused("signal = 'heigth', low = 0, sentence = 'why'", {"output 'heigth'", "height"}));
  EXPECT_TRUE(refused("low = 0, sentence = 'why'", {"limits.low", "signal"}));
  EXPECT_TRUE(refused("signal = { element = 'sea', quantity = 'power' }, low = 0, sentence = 'why'",
                      {"element 'sea'", "air"}));
  EXPECT_TRUE(refused("signal = { element = 'air', quantity = 'lift' }, low = 0, sentence = 'why'",
                      {"quantity 'lift'", "power"}));
  EXPECT_TRUE(refused("signal = { element = 'air', quantity = 'power', gain = 2 }, low = 0, sentence = 'why'",
                      {"gain"}));
  EXPECT_TRUE(refused("signal = 'height', sentence = 'why'", {"limits.low", "low"}));
  EXPECT_TRUE(refused("signal = 'height', low = 2, high = 1, sentence = 'why'", {"is 2", "below high, 1"}));
  EXPECT_TRUE(refused("signal = 'height', low = 0", {"sentence"}));
  EXPECT_TRUE(refused("signal = 'height', low = 0, on_leaving = 'end', sentence = 'why'", {"'end'", "stop"}));
}

}  // namespace
}  // namespace tandem::mbs
