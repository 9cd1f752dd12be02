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

/// Was quadratic: 10^6 names were each compared with all others.
TEST(TimeTable, ReadsAsManyColumnsAsItAllowsAndRefusesMore) {
  const Scratch folder;
  const auto table = [&](std::size_t columns, const std::string& more) {
    std::string names = "time", row = "0";
    for (std::size_t k = 1; k < columns; ++k) names += ",c" + std::to_string(k), row += ",1";
    return folder.write("r.csv", names + more + "\n" + row + (more.empty() ? "" : ",1") + "\n");
  };
  constexpr std::size_t most = std::size_t{1} << 20;
  EXPECT_EQ(TimeTable::read(table(most, "")).names.size(), most - 1);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"r.csv:1: there are more than 1048576 columns, the most allowed"},
                      [&] { TimeTable::read(table(most, ",x")); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"r.csv:1: the name of column 1000001 is there twice"},
                      [&] { TimeTable::read(table(1'000'000, ",c7")); }));
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
  EXPECT_TRUE(refused("time,x\n0,1\n1,abc\n", {"r.csv:3", "column 2"}));
  EXPECT_TRUE(refused("time,x\n0,1\n1,2e\n", {"r.csv:3", "column 2"}));
  EXPECT_TRUE(refused("time,x\n0,inf\n", {"r.csv:2", "finite"}));
  EXPECT_TRUE(refused("time,x\n0,1\n,2\n", {"r.csv:3: column 1 is empty; allowed is a finite number"}));
  EXPECT_TRUE(refused("time,\"x\n0,1\n", {"r.csv:1: a quotation mark is not closed"}));
  EXPECT_TRUE(refused("time,x\n0\n", {"r.csv:2", "1 cells", "2"}));
  EXPECT_TRUE(refused("time,x\n1,1\n0,1\n", {"r.csv:3", "time falls"}));
  EXPECT_TRUE(refused("x,time\n1,1\n", {"r.csv:1", "allowed is time"}));
  EXPECT_TRUE(refused("time,x,x\n1,1,1\n", {"r.csv:1", "the name of column 3 is there twice"}));
  EXPECT_TRUE(refused("", {"r.csv", "empty"}));
  EXPECT_TRUE(refused("time,x\n", {"r.csv", "no rows"}));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"nowhere.csv", "not there"}, [] { TimeTable::read("nowhere.csv"); }));
}

}  // namespace
}  // namespace tandem::text
