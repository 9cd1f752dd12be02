// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Charts of kind table: which rows stand in which cell, and how numbers are written.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/charts/draw.hpp"

namespace tandem::charts {
namespace table_chart {

class TableChartTest : public testing::Test {
 protected:
  TableChartTest() {
    folder_.write(
        "t.csv",
        "how,size,ns,ratio,status\na,2,10.4,1.00,ok\na,4,20,1.5,ok\nb,2,123.456,0.9,ok\nb,4,,,lost\n");
  }
  std::string made(const std::string& keys) {
    const text::Document document("c.toml", "[[charts]]\nname = 'c'\nkind = 'table'\ntable = 't'\n" + keys);
    text::Section root(document, tandem::charts::keys());
    return draw(read_charts(root), folder_.path(), "").sheets.at(0).text;
  }
  test::Scratch folder_;
};

TEST_F(TableChartTest, ARowForEachAndAColumnForEachOfItsCells) {
  EXPECT_EQ(made("rows = ['how', 'size']\ncells = ['ns', 'ratio']\ndigits = 3\n"),
            "| how | size | ns | ratio |\n|---|---|---|---|\n| a | 2 | 10.4 | 1.00 |\n| a | 4 | 20 | 1.5 |\n"
            "| b | 2 | 123 | 0.9 |\n| b | 4 | lost | lost |\n");
}

TEST_F(TableChartTest, AColumnForEachValueAndWhatItHasInOneCell) {
  EXPECT_EQ(made("rows = 'how'\ncolumns = 'size'\ncells = ['ns', '2*ratio']\n"),
            "| how | size: 2 | 4 |\n|---|---|---|\n| a | 10 (2) | 20 (3) |\n| b | 123 (1.8) | lost |\n");
}

TEST_F(TableChartTest, AWordStandsInACellAsItIsCalled) {
  EXPECT_EQ(made("rows = 'size'\nwhere = 'ns < 15'\ncells = ['how', 'ns']\nwords = { a = 'the first' }\n"),
            "| size | how | ns |\n|---|---|---|\n| 2 | the first | 10 |\n");
}

TEST_F(TableChartTest, SeveralRowsInACellMakeOneNumber) {
  EXPECT_EQ(
      made("rows = 'how'\ncells = ['1', 'ns > 15', 'ns', 'ns', 'ns']\n"
           "each = ['sum', 'sum', 'mean', 'least', 'most']\ndigits = 3\n"),
      "| how | 1 | ns > 15 | ns | ns | ns |\n|---|---|---|---|---|---|\n| a | 2 | 1 | 15.2 | 10.4 | 20 |\n"
      "| b | 1 | 1 | 123 | 123 | 123 |\n");
}

TEST_F(TableChartTest, SeveralRowsInACellAreRefusedWithoutAWordOfWhatTheyMake) {
  const auto refused = [&](const std::string& keys, const std::vector<std::string>& words) {
    return test::refuses(ErrorCode::invalid_argument, words, [&] { made(keys); });
  };
  EXPECT_TRUE(refused("rows = 'how'\ncells = 'ns'\n", {"c.toml:1", "rows 1 and 2 of t.csv", "each"}));
  EXPECT_TRUE(
      refused("rows = 'how'\ncells = 'ns'\neach = 'median'\n", {"median", "sum, mean, least or most"}));
  EXPECT_TRUE(
      refused("rows = 'how'\ncells = 'ns'\neach = ['sum', 'mean']\n", {"each", "2 words", "as cells has (1)"}));
}

}  // namespace table_chart
}  // namespace tandem::charts
