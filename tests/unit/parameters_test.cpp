// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/parameters.hpp"

#include <gtest/gtest.h>

#include <random>

#include "refusal.hpp"

namespace tandem {
namespace {

using test::refuses;

TEST(Parameters, GiveWhatWasSetAndElseTheDefault) {
  Parameters p;
  p.set("mass", 2.5);
  p.set("on", true);
  p.set("file", std::string("a.toml"));
  EXPECT_EQ(p.number("mass", 1.0), 2.5);
  EXPECT_EQ(p.number("length", 1.0), 1.0);
  EXPECT_TRUE(p.flag("on", false));
  EXPECT_TRUE(p.flag("off", true));
  EXPECT_EQ(p.text("file", ""), "a.toml");
  EXPECT_EQ(p.text("other", "b"), "b");
  EXPECT_TRUE(p.has("mass"));
  EXPECT_FALSE(p.has("length"));
}

TEST(Parameters, ReadNumbersAndFlagsFromTextsOfAUri) {
  Parameters p;
  p.set("h", std::string("-2.5e-3"));
  p.set("on", std::string("true"));
  p.set("off", std::string("false"));
  EXPECT_EQ(p.number("h", 0.0), -2.5e-3);
  EXPECT_TRUE(p.flag("on", false));
  EXPECT_FALSE(p.flag("off", true));
}

/// As names and texts of FMUs may be.
TEST(Parameters, MayHoldTheSignsThatPairsAreMadeOf) {
  Parameters p;
  p.read("set.a%26b%3D1=x%2526%26&set.c=50%&set.d=%2", "URI");
  EXPECT_EQ(p.names("set."), (std::vector<std::string>{"a&b=1", "c", "d"}));
  EXPECT_EQ(p.text("set.a&b=1", ""), "x%26&");
  EXPECT_EQ(p.text("set.c", ""), "50%");
  EXPECT_EQ(p.text("set.d", ""), "%2");
}

/// Others read them in their own languages, and would read something else.
TEST(Parameters, ThatGoElsewhereHoldNoneOfThese) {
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a", "x&y"}, {"a", "%26"}, {"a%3D", "x"}, {"a=b", "x"}, {"a&", "x"}}) {
    Parameters p;
    p.set(name, text);
    EXPECT_TRUE(
        refuses(ErrorCode::invalid_argument, {"'" + name + "'", "'" + text + "'"}, [&] { p.rest(); }));
  }
  Parameters p;
  p.set("a", "50% = %2");
  EXPECT_EQ(p.rest(), "a=50% = %2");
}

/// What this program itself will read holds any.
TEST(Parameters, AreReadBackAsTheyWereWhereTheyAreEscaped) {
  std::mt19937 random(5);
  const std::string signs = "&=%26D3a?";
  const auto word = [&](std::size_t least) {
    std::string text;
    for (std::size_t k = random() % 6 + least; k > 0; --k) text += signs[random() % signs.size()];
    return text;
  };
  for (int trial = 0; trial < 200; ++trial) {
    const std::string name = word(1), text = word(0);
    Parameters p, back;
    p.set(name, text);
    back.read(p.rest_escaped(), "URI");
    EXPECT_EQ(back.text(name, "other"), text) << name;
  }
}

TEST(Parameters, RefuseAnotherType) {
  Parameters p;
  p.set("h", std::string("1.5x"));
  p.set("empty", std::string());
  p.set("on", 1.0);
  p.set("file", true);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'h'", "'1.5x'", "a number is allowed"},
                      [&] { p.number("h", 0.0); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'empty'"}, [&] { p.number("empty", 0.0); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'on'", "true or false is allowed"},
                      [&] { p.flag("on", false); }));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'file'", "a text is allowed"}, [&] { p.text("file", ""); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'file'"}, [&] { p.number("file", 0.0); }));
}

TEST(Parameters, NameWhatNobodyAskedForAndTheNearestThatWas) {
  Parameters p;
  p.set("frequncy_ratio", 30.0);
  p.number("frequency_ratio", 1.0);
  p.number("k2", 1.0);
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument,
              {"source 'x'", "'frequncy_ratio'", "did you mean 'frequency_ratio'", "frequency_ratio, k2"},
              [&] { p.refuse_unused("source 'x'"); }));
}

TEST(Parameters, AreContentWhenAllWereAskedFor) {
  Parameters p;
  p.set("k2", 1.0);
  p.number("k2", 2.0);
  p.number("m1", 2.0);
  EXPECT_NO_THROW(p.refuse_unused("source 'x'"));
}

}  // namespace
}  // namespace tandem
