// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/nesting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/text/document.hpp"

namespace tandem::text {
namespace {

using test::refuses;

std::string times(int count, const std::string& text) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

std::string dotted(int parts) { return times(parts - 1, "a.") + "a"; }

/// What has a depth of this number, in each way that TOML has.
std::vector<std::string> of_depth(int depth) {
  return {"[" + dotted(depth) + "]\n",
          "[[" + dotted(depth - 1) + "]]\n",
          "['" + times(depth - 1, "a'.'") + "a']\n",
          dotted(depth + 1) + " = 1\n",
          times(depth, "a . ") + "a = 1\n",
          "a = " + times(depth, "[") + times(depth, "]") + "\n",
          "a = " + times(depth - 1, "[\n") + "[1.5, 2.5]" + times(depth - 1, "]\n") + "\n",
          "a = " + times(depth - 1, "{ a = ") + "{}" + times(depth - 1, "}") + "\n",
          "[a.b]\nc.d = [" + times(depth - 5, "{a=") + "1" + times(depth - 5, "}") + "]\n"};
}

TEST(Nesting, CountsBracketsAndTheDotsOfKeys) {
  for (const std::string& text : of_depth(12)) {
    EXPECT_EQ(deeper_than(text, 13), 0) << text;
    EXPECT_GT(deeper_than(text, 10), 0) << text;
    EXPECT_NO_THROW(Document("it", text)) << text;
  }
}

TEST(Nesting, WhatIsTooDeepIsRefusedByItsLineBeforeItIsParsed) {
  for (const int depth : {200, 50'000, 1'000'000})
    for (const std::string& text : of_depth(depth))
      EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"it:", too_deep}, [&] { Document("it", text); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"it:3: "},
                      [] { Document("it", "a = 1\n\n" + dotted(200) + " = 1\n"); }));
  const std::string both = "[" + dotted(60) + "]\n" + dotted(60) + " = 1\n";
  EXPECT_THROW(Document("it", both), Error);
}

TEST(Nesting, DotsAndBracketsInTextsAndCommentsAreNone) {
  const std::string many = times(500, ".[{");
  for (const std::string& text : std::vector<std::string>{
           "a = \"" + many + "\"\n", "a = '" + many + "'\n",
           "a = \"\"\"\n" + many + "\n\\\"\"\" " + many + "\"\"\"\n",
           "a = '''\n" + many + "''' # " + many + "\n", "a = 1 # " + many + "\n", "# '\na.b = 1 # \"\n",
           "\"" + many + "\" = 1\n", "['" + many + "']\na = \"\\\\\"\nb = '\\'\n",
           "a = \"\"\nb = ''\nc = \"\"\"\"\"\"\n", "a = \"\"\"x\"\"\"\"\" # \"\n", "a = '''x'''''\n"}) {
    EXPECT_EQ(deeper_than(text, 4), 0) << text;
    EXPECT_NO_THROW(Document("it", text)) << text;
  }
}

TEST(Nesting, ManyThatStandBesideEachOtherAreNotDeep) {
  const std::string text = "a = [" + times(2000, "1.25, [0.5], {b.c = 1.5}, ") + "2024-01-01]\n" +
                           times(1000, "[[b.c]]\nd.e = 1.5\n") + times(1000, "[[f]]\n");
  EXPECT_EQ(deeper_than(text, 6), 0);
  EXPECT_NO_THROW(Document("it", text));
}

int depth_of(const toml::node& node) {
  int deepest = 0;
  if (const auto* table = node.as_table())
    for (const auto& [key, value] : *table) deepest = std::max(deepest, depth_of(value));
  if (const auto* array = node.as_array())
    for (const toml::node& value : *array) deepest = std::max(deepest, depth_of(value));
  return deepest + (node.is_value() ? 0 : 1);
}

/// Sound documents at random, with texts that look like what they are not.
class Documents {
 public:
  std::string one() {
    std::string text;
    for (int table = 0; table < 4; ++table) {
      for (int k = 0; k < 3; ++k) text += key() + pick({"=", " = ", "  =\t"}) + value(3) + comment() + "\n";
      text +=
          pick({"", "\n", "  "}) + (chance() ? "[" + key() + "]" : "[[" + key() + "]]") + comment() + "\n";
    }
    return text;
  }

 private:
  bool chance() { return random_() % 2 == 0; }
  std::string pick(const std::vector<std::string>& from) { return from[random_() % from.size()]; }
  std::string comment() { return pick({"", "", " # it's [a.b.c] = {", " #\"\"\""}); }
  /// Never the same twice.
  std::string key() {
    std::string text = "k" + std::to_string(++keys_);
    for (auto more = random_() % 4; more > 0; --more) text += pick({".b", " . c-d", ".\"e.[\\\"\"", ".'f#'"});
    return text;
  }
  std::string value(int deep) {
    switch (random_() % (deep > 0 ? 8 : 6)) {
      case 6:
        return "[" + pick({"", "\n", " # ]\n"}) + value(deep - 1) + ", " + value(deep - 1) + "]";
      case 7:
        return "{ " + key() + " = " + value(deep - 1) + ", " + key() + " = " + value(deep - 1) + " }";
      default:
        return pick({"1.5e-3", "2024-05-06T07:08:09.123", "\"[.\\\\\"", "'''[\n.''''",
                     "\"\"\"\\\"\"\"\\\n{.\"\"\"", "''", "\"\"", "'\\'", "0.5"});
    }
  }
  std::mt19937_64 random_{20260};
  int keys_ = 0;
};

TEST(Nesting, IsNeverLessThanThatOfTheDocumentAndTwoMoreAtMost) {
  Documents documents;
  for (int k = 0; k < 2000; ++k) {
    const std::string text = documents.one();
    const int depth = depth_of(Document("it", text).table()) - 1;  // the document itself is a table
    ASSERT_GT(deeper_than(text, depth - 1), 0) << depth << " of\n" << text;
    ASSERT_EQ(deeper_than(text, depth + 2), 0) << depth << " of\n" << text;
  }
}

TEST(Nesting, DocumentsThatEndAnywhereAreCountedToTheirEnd) {
  Documents documents;
  for (int k = 0; k < 20; ++k) {
    const std::string text = documents.one();
    for (std::size_t size = 0; size < text.size(); ++size)
      ASSERT_EQ(deeper_than(text.substr(0, size), 100), 0) << text.substr(0, size);
  }
}

TEST(Nesting, EachFileOfTheScenesIsFarFromTheLimit) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TANDEM_SOURCE_DIR "/scenarios"))
    if (entry.path().extension() == ".toml") {
      EXPECT_EQ(deeper_than(test::read_text(entry.path()), deepest_nesting / 4), 0) << entry.path();
      ++files;
    }
  EXPECT_GT(files, 30);
}

}  // namespace
}  // namespace tandem::text
