// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/csv_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

using test::refuses;

class CsvTableTest : public testing::Test {
 protected:
  CsvTable read(const std::string& text) { return CsvTable::read(folder_.write("t.csv", text), {"a", "b"}); }
  testing::AssertionResult refused(const std::string& text, const std::string& why) {
    return refuses(ErrorCode::input_output, {"t.csv', " + why}, [&] { read(text); });
  }
  test::Scratch folder_;
};

TEST_F(CsvTableTest, CellsAreFoundByColumnWhateverTheOrder) {
  const CsvTable table = read("b,other,a\n1,x,2\n3,y,4\n");
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table[0].number("a"), 2.0);
  EXPECT_EQ(table[1].number("b"), 3.0);
  EXPECT_EQ(table[1].text("other"), "y");
}

TEST_F(CsvTableTest, QuotedCellsMayHoldCommasAndQuotes) {
  const CsvTable table = read("a,b\n1,\"so, \"\"it\"\" was\"\n");
  EXPECT_EQ(table[0].text("b"), "so, \"it\" was");
}

TEST_F(CsvTableTest, LinesMayEndAsOnWindowsAndTheLastOneNotAtAll) {
  const CsvTable table = read("a,b\r\n1,2\r\n3,4");
  EXPECT_EQ(table[0].number("b"), 2.0);
  EXPECT_EQ(table[1].number("b"), 4.0);
}

TEST_F(CsvTableTest, AnEmptyCellIsNotANumber) {
  const CsvTable table = read("a,b\n,2\n");
  EXPECT_TRUE(std::isnan(table[0].number("a")));
}

TEST_F(CsvTableTest, AFileThatCanNotBeReadIsNamed) {
  const auto absent = folder_.path() / "absent.csv";
  EXPECT_TRUE(refuses(ErrorCode::input_output, {absent.string(), "is not there"},
                      [&] { CsvTable::read(absent, {}); }));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"can't be read"}, [&] { CsvTable::read(folder_.path(), {}); }));
}

TEST_F(CsvTableTest, BadHeadersAndRowsAreRefusedByLine) {
  EXPECT_TRUE(refused("", "line 1: column 'a' is missing"));
  EXPECT_TRUE(refused("a,c\n", "line 1: column 'b' is missing"));
  EXPECT_TRUE(refused("a,b,a\n", "line 1: the name of column 3 stands there twice"));
  EXPECT_TRUE(refused("a,b\n1,2\n1,2,3\n", "line 3: 3 cells; the header has 2"));
  EXPECT_TRUE(refused("a,b\n\n1,2\n", "line 2: 1 cells; the header has 2"));
  EXPECT_TRUE(refused("a,b\n1,\"2\n", "line 2: a cell in quotes does not end"));
}

TEST_F(CsvTableTest, BadNumbersAreRefusedByLineAndColumn) {
  const CsvTable table = read("a,b\n1,2\n1x,0\n");
  EXPECT_TRUE(refuses(ErrorCode::input_output,
                      {"line 3: a is something else; allowed is a number, or nothing"},
                      [&] { table[1].number("a"); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"line 3: b is something else; allowed is a number above 0"},
                      [&] { table[1].positive("b"); }));
}

}  // namespace
}  // namespace tandem::charts
