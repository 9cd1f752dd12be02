// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/time_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::text {
namespace {

using test::refuses;
using test::Scratch;

TEST(TimeTable, ReadsColumnsEmptyCellsAndQuotedNames) {
  const Scratch folder;
  const TimeTable t =
      TimeTable::read(folder.write("r.csv", "time,\"a,\"\"b\"\"\",c\r\n0,1,2\r\n1e-3,,-4.5\r\n"));
  EXPECT_EQ(t.names, (std::vector<std::string>{"a,\"b\"", "c"}));
  EXPECT_EQ(t.times, (std::vector<double>{0.0, 0.001}));
  EXPECT_TRUE(std::isnan(t.columns[0][1]));
  EXPECT_EQ(t.columns[1][1], -4.5);
}

TEST(TimeTable, LooksOverTheMarkOfUtf8) {
  const Scratch folder;
  EXPECT_EQ(TimeTable::read(folder.write("r.csv", "\xEF\xBB\xBFtime,x\r\n0,1\r\n")).times,
            (std::vector{0.0}));
}

TEST(TimeTable, TakesTheFolderThatHoldsResults) {
  const Scratch folder;
  folder.write("results.csv", "time,x\n0,1\n");
  EXPECT_EQ(TimeTable::read(folder.path()).columns[0][0], 1.0);
}

TEST(TimeTable, NamesFileLineAndTextOfWhatIsWrong) {
  const Scratch folder;
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words, [&] { TimeTable::read(folder.write("r.csv", text)); });
  };
  EXPECT_TRUE(refused("time,x\n0,1\n1,abc\n", {"r.csv:3", "column x", "'abc'"}));
  EXPECT_TRUE(refused("time,x\n0,1\n1,2e\n", {"r.csv:3", "'2e'"}));
  EXPECT_TRUE(refused("time,x\n0,inf\n", {"r.csv:2", "'inf'"}));
  EXPECT_TRUE(refused("time,x\n0,1\n,2\n", {"r.csv:3: column time is empty; allowed is a finite number"}));
  EXPECT_TRUE(refused("time,\"x\n0,1\n", {"r.csv:1: a quotation mark is not closed"}));
  EXPECT_TRUE(refused("time,x\n0\n", {"r.csv:2", "1 cells", "2"}));
  EXPECT_TRUE(refused("time,x\n1,1\n0,1\n", {"r.csv:3", "time falls to 0"}));
  EXPECT_TRUE(refused("x,time\n1,1\n", {"r.csv:1", "'x'", "time"}));
  EXPECT_TRUE(refused("time,x,x\n1,1,1\n", {"r.csv:1", "x is there twice"}));
  EXPECT_TRUE(refused("", {"r.csv", "empty"}));
  EXPECT_TRUE(refused("time,x\n", {"r.csv", "no rows"}));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"nowhere.csv", "not there"}, [] { TimeTable::read("nowhere.csv"); }));
}

}  // namespace
}  // namespace tandem::text
