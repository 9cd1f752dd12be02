// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/style.hpp"

#include <gtest/gtest.h>

#include <set>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

using test::refuses;

const char* const conditions =
    R"({"processor": "P", "compiler": "C", "commit": "c", "reference": "exact motion",
                                   "error_norm": "rms", "repetitions": 5})";

TEST(Style, LinesAndMarkersDifferInMoreThanColour) {
  std::set<std::string> lines, markers;
  for (int k = 0; k < 6; ++k) {
    lines.insert(line_of(k));
    markers.insert(marker_of(k).substr(marker_of(k).find(" pt ")));
  }
  EXPECT_EQ(lines.size(), 6U);
  EXPECT_EQ(markers.size(), 6U);
}

TEST(Style, TheCaptionStatesTheConditions) {
  const test::Scratch scratch;
  const auto lines = conditions_caption(scratch.write("conditions.json", conditions), 1000);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(
      lines[0],
      "processor: P   compiler: C   commit: c   reference: exact motion   error norm: rms   repetitions: 5");
}

TEST(Style, LongCaptionsAreBroken) {
  const test::Scratch scratch;
  const auto lines = conditions_caption(scratch.write("conditions.json", conditions), 40);
  EXPECT_EQ(lines.size(), 3U);
  for (const std::string& line : lines) EXPECT_LE(line.size(), 40U);
}

TEST(Style, BadConditionsAreNamed) {
  const test::Scratch scratch;
  const auto refused = [&](const std::string& text, const std::string& why) {
    const auto file = scratch.write("c.json", text);
    return refuses(ErrorCode::input_output, {"c.json", why}, [&] { conditions_caption(file, 100); });
  };
  EXPECT_TRUE(refused(R"({"processor": "P"})", "key 'compiler' is missing"));
  EXPECT_TRUE(refused("[]", "key 'processor' is missing"));
  EXPECT_TRUE(refused("{\n\"processor\" 1}", "line 2"));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"absent.json", "is not there"},
                      [&] { conditions_caption(scratch.path() / "absent.json", 100); }));
}

}  // namespace
}  // namespace tandem::charts
