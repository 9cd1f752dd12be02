// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Charts that files describe: what is refused, and what their scripts draw.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/charts/draw.hpp"

namespace tandem::charts {
namespace {

using test::refuses;
using test::Scratch;

Charts charts_of(const std::string& text) {
  const text::Document document("c.toml", text);
  text::Section root(document, keys());
  Charts charts = read_charts(root);
  root.refuse_unknown();
  return charts;
}

const std::string curves = "[[charts]]\nname = 'c'\nkind = 'curves'\ntable = 't'\nx = 'x'\ny = 'y'\n";
const std::string work = "[[charts]]\nname = 'c'\nkind = 'work'\ntable = 't'\ncost = 'x'\nerror = 'y'\n";
const std::string map =
    "[[charts]]\nname = 'c'\nkind = 'map'\ntable = 't'\nrows = 'how'\ncolumns = 'x'\nvalue = 'y'\n"
    "limits = [0.1, 1]\n";
const std::string traces = "[[charts]]\nname = 'c'\nkind = 'traces'\ntable = 't'\ny = 'y'\n";

class ChartTest : public testing::Test {
 protected:
  ChartTest() {
    table(
        "x,y,y.floor,how,status\n1,0.5,0.01,a,ok\n2,0.25,0.02,a,ok\n4,9,0.01,a,ok\n1,0.05,0.01,b,ok\n"
        "2,0.02,0.01,b,ok\n4,,,b,lost\n");
  }
  void table(const std::string& text) { folder_.write("t.csv", text); }
  Drawing drawn(const std::string& text) { return draw(charts_of(text), folder_.path(), ""); }
  std::string script(const std::string& text) { return drawn(text).pictures.at(0).script(); }
  testing::AssertionResult refused(const std::string& text, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words, [&] { drawn(text); });
  }
  Scratch folder_;
};

testing::AssertionResult has(const std::string& script, const std::string& text) {
  if (script.find(text) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << text << " is not in:\n" << script;
}

TEST_F(ChartTest, CurvesHaveALineForEachSeriesInOrderOfX) {
  table("x,y,how\n4,3,a\n1,2,a\n2,5,b\n");
  const std::string drawn = script(curves + "series = 'how'\n");
  EXPECT_TRUE(has(drawn, "<< END\n1 2\n4 3\nEND\n"));
  EXPECT_TRUE(has(drawn, "<< END\n2 5\nEND\n"));
  EXPECT_TRUE(has(drawn, "title 'a'"));
}

TEST_F(ChartTest, AnExpressionStandsForAColumn) {
  EXPECT_TRUE(has(script("[[charts]]\nname = 'c'\nkind = 'curves'\ntable = 't'\nx = 'x'\ny = '2*y + x'\n"
                         "where = '(how is a) && x < 4'\n"),
                  "<< END\n1 2\n2 2.5\nEND\n"));
}

TEST_F(ChartTest, WhatIsNoResultInterruptsTheLineAndStandsInTheBand) {
  const std::string drawn = script(curves + "series = 'how'\nlog = ['x', 'y']\nlimit = 1\n");
  EXPECT_TRUE(has(drawn, "<< END\n1 0.5\n2 0.25\n4 nan\nEND\n"));
  EXPECT_TRUE(has(drawn, "<< END\n1 0.05\n2 0.02\n4 nan\nEND\n"));
  EXPECT_TRUE(has(drawn, "'failed, or above 1'"));
  EXPECT_TRUE(has(drawn, "first 1 to graph 1, graph 1 behind"));  // the band begins at the limit
}

TEST_F(ChartTest, MarkersAreHollowWhereTheExpressionSaysSoOrHasNoValue) {
  table("x,y,z\n1,1,0\n2,2,5\n3,3,\n");
  const std::string drawn = script(curves + "hollow = 'z > 1'\n");
  EXPECT_TRUE(has(drawn, "<< END\n1 1\nEND\n"));
  EXPECT_TRUE(has(drawn, "<< END\n2 2\n3 3\nEND\n"));
}

TEST_F(ChartTest, PercentCountsForAxisLimitAndLines) {
  const std::string drawn =
      script(curves + "percent = true\nlimit = 0.4\nlines = [{ y = 0.3, name = 'here' }]\n");
  EXPECT_TRUE(has(drawn, "'y [%]'"));
  EXPECT_TRUE(has(drawn, "'failed, or above 40 %'"));
  EXPECT_TRUE(has(drawn, " 30\n"));
  EXPECT_TRUE(has(drawn, "title 'here'"));
}

TEST_F(ChartTest, WordsStandSideBySideWithAPlaceForEachSeries) {
  table("x,y,how\nleft,1,a\nright,2,a\nleft,3,b\n");
  const std::string drawn = script(curves + "series = 'how'\n[names]\nleft = 'the left'\n");
  EXPECT_TRUE(has(drawn, "set xtics ('the left' 0, 'right' 1)"));
  EXPECT_TRUE(has(drawn, "<< END\n-0.2 1\n0.8 2\nEND\n"));
  EXPECT_TRUE(has(drawn, "<< END\n0.2 3\nEND\n"));
}

TEST_F(ChartTest, WorkHasItsFrontFloorAndTolerance) {
  const std::string drawn = script(work + "colour = 'how'\nfront = true\ntolerance = 0.1\n");
  EXPECT_TRUE(has(drawn, "<< END\n1 0.05\n2 0.02\nEND\n"));  // of the front
  EXPECT_TRUE(has(drawn, "'error of the reference'"));
  EXPECT_TRUE(has(drawn, " 0.02\n"));  // the largest of the floors
  EXPECT_TRUE(has(drawn, "title 'tolerance'"));
  EXPECT_TRUE(has(script(work + "floor = '2*x'\n"), " 8\n"));
}

TEST_F(ChartTest, AnOverlayHasThePointsOfASecondTableInItsPanel) {
  folder_.write("other.csv", "x,y,how\n3,7,b\n5,8,c\n");
  const std::string drawn =
      script(work + "panels = 'how'\noverlay = { table = 'other', name = 'whole', where = 'x < 5' }\n");
  EXPECT_TRUE(has(drawn, "<< END\n3 7\nEND\n"));
  EXPECT_TRUE(has(drawn, "title 'whole'"));
  EXPECT_EQ(drawn.find("5 8"), std::string::npos);
}

TEST_F(ChartTest, AMapHasShadesSignsAndTheBestOfEachColumn) {
  const Drawing drawing = drawn(map + "signs = [{ when = 'y > 5', name = 'large' }]\nbest = 0.03\n");
  const std::string script = drawing.pictures.at(0).script();
  EXPECT_TRUE(has(script, "<< END\n0 1\n1 1\nEND\n"));  // up to 0.1: b at 1 and 2
  EXPECT_TRUE(has(script, "<< END\n0 0\n1 0\nEND\n"));  // up to 1: a at 1 and 2
  EXPECT_TRUE(has(script, "title 'large'"));
  EXPECT_TRUE(has(script, "<< END\n2 1\nEND\n"));  // lost: b at 4
  EXPECT_EQ(drawing.words, "         1  none\n         2  b (0.02)\n         4  none\n");
}

TEST_F(ChartTest, AMapMarksTheBestOfSomeCellsToo) {
  const std::string drawn = script(map + "best = 1\nalso = { when = '(how is a)', name = 'of a' }\n");
  EXPECT_TRUE(has(drawn, "title 'of a'"));
  EXPECT_TRUE(has(drawn, "$d5 << END\n0 0\n1 0\nEND\n"));  // after both shades, what is out, and the best
  EXPECT_TRUE(refused(map + "also = { when = 'x' }\n", {"c.toml:9: charts[0].also.name is missing"}));
}

TEST_F(ChartTest, AMapHasTheFirstLetterOfAColumnInItsCells) {
  const std::string drawn = script(map + "text = 'how'\nwords = { b = 'zero' }\n");
  EXPECT_TRUE(has(drawn, "pt 'a' ps 1 lc rgb"));
  EXPECT_TRUE(has(drawn, "pt 'z' ps 1 lc rgb 'white'"));  // on a dark shade
  EXPECT_TRUE(refused(map + "text = 'wat'\n", {"c.toml", "'wat' is missing"}));
}

TEST_F(ChartTest, TracesHaveWindowsDifferencesAndJumps) {
  table("time,y,y.exact,gear\n0,1,1,1\n1,2,2.5,1\n2,4,4,2\n3,5,5,2\n");
  const std::string drawn =
      script(traces + "windows = [[0, 1.5], [1.5, 3]]\ndifference = 'exact'\njumps = 'gear'\n");
  EXPECT_TRUE(has(drawn, "<< END\n0 1\n1 2\nEND\n"));
  EXPECT_TRUE(has(drawn, "<< END\n2 4\n3 5\nEND\n"));
  EXPECT_TRUE(has(drawn, "<< END\n0 0\n1 -0.5\nEND\n"));
  EXPECT_TRUE(has(drawn, "'difference from exact'"));
  EXPECT_TRUE(has(drawn, "'gear changes'"));
}

TEST_F(ChartTest, ATablesJsonGivesUnitsAndHowItWasMade) {
  folder_.write("t.json",
                R"({"units": {"y": "rad"}, "norms": {"y": "largest of all"}, "made": {"commit": "abc"}})");
  const std::string drawn = script(curves);
  EXPECT_TRUE(has(drawn, "'y [rad]'"));
  EXPECT_TRUE(has(drawn, "'y: largest of all'"));
  EXPECT_TRUE(has(drawn, "'commit: abc'"));
}

TEST_F(ChartTest, WhatIsWrongIsRefusedWithItsPlace) {
  EXPECT_TRUE(refused(curves + "limit = -1\n", {"c.toml:7: charts[0].limit is the number -1", "above 0"}));
  EXPECT_TRUE(refused("[[charts]]\nname = 'a/b'\nkind = 'curves'\n", {"c.toml:2", "letters, digits and _"}));
  EXPECT_TRUE(refused("[[charts]]\nname = 'a'\nkind = 'pie'\n", {"c.toml:3", "curves", "traces"}));
  EXPECT_TRUE(
      refused("[[charts]]\nname = 'a'\nkind = 'curves'\ntable = '../t'\n", {"c.toml:4", "no dot first"}));
  EXPECT_TRUE(refused(curves + "cost = 'x'\n", {"unknown key of [charts[0]] 'cost'"}));
  EXPECT_TRUE(refused(curves + curves, {"which another chart has"}));
  EXPECT_TRUE(refused(curves + "series = 'wat'\n", {"c.toml:1", "t.csv: column 'wat' is missing"}));
  EXPECT_TRUE(refused(curves + "where = 'x > 100'\n", {"t.csv has no row where x > 100 to draw"}));
  EXPECT_TRUE(refused(curves + "where = 'x ='\n", {"c.toml:7"}));
  EXPECT_TRUE(refused(work + "hollow = 'how + 1'\n", {"c.toml:7", "t.csv, line 2", "has a word where"}));
  EXPECT_TRUE(refused(map + "signs = [{ name = 'n' }]\n", {"when is missing"}));
  EXPECT_TRUE(
      refused("[[charts]]\nname = 'c'\nkind = 'traces'\ntable = 't'\ny = []\n", {"at least one quantity"}));
  EXPECT_TRUE(refused(traces + "windows = [[2, 1]]\n", {"FROM below TO"}));
}

TEST_F(ChartTest, ATableThatIsNotThereIsNamed) {
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"c.toml:1", "no.csv", "is not there"}, [&] {
    drawn("[[charts]]\nname = 'c'\nkind = 'curves'\ntable = 'no'\nx = 'x'\ny = 'y'\n");
  }));
  EXPECT_TRUE(refused("[[charts]]\nname = 'c'\nkind = 'curves'\nx = 'x'\ny = 'y'\n", {"c names no table"}));
}

TEST_F(ChartTest, ATableHasACellForEachRowAndColumn) {
  table("x,how,y,z,status\n1,a,0.01234,0.5,ok\n2,a,5e-05,1500,ok\n1,b,3,1e7,ok\n2,b,,,lost\n");
  const std::string head = "[[charts]]\nname = 'c'\nkind = 'table'\ntable = 't'\nrows = 'how'\n";
  const Drawing pivot = drawn(head + "columns = 'x'\ncells = ['y', 'z']\nwords = { a = 'first' }\n");
  ASSERT_EQ(pivot.sheets.size(), 1U);
  EXPECT_EQ(pivot.sheets[0].name, "c.md");
  EXPECT_EQ(pivot.sheets[0].text,
            "| how | x: 1 | 2 |\n|---|---|---|\n"
            "| first | 0.012 (0.5) | 5.0e-05 (1500) |\n| b | 3 (10000000) | lost |\n");
  EXPECT_EQ(drawn(head + "where = 'x < 1.5'\ncells = ['y', '2*z']\ndigits = 4\n").sheets[0].text,
            "| how | y | 2*z |\n|---|---|---|\n| a | 0.01234 | 1 |\n| b | 3 | 20000000 |\n");
  EXPECT_TRUE(refused(head + "where = 'x < 1.5'\ncells = 'q'\n", {"q", "is missing"}));
  EXPECT_TRUE(refused(head + "cells = 'y'\ndigits = 2.5\n", {"digits", "2.5", "a whole number up to 17"}));
  EXPECT_TRUE(refused(head + "cells = 'y'\ncolumns = 'w'\n", {"'w'", "is missing"}));
}

}  // namespace
}  // namespace tandem::charts
