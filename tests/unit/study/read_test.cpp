// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/study/study.hpp"

namespace tandem::study {
namespace {

const std::string head = "scenario = 'scene.toml'\n";

Study of(const std::string& text) {
  const test::Scratch folder;
  return read(folder.write("study.toml", head + text));
}

std::vector<FileValues> rows_of(const std::string& text) { return of(text).tables[0].rows; }

TEST(StudyAxes, MultiplyTheLastOneFirstAndBlocksAddUp) {
  const auto rows = rows_of(
      "[[tables.t.blocks]]\naxes = [{ a = [1, 2] }, { b = ['x', 'y'], c = [10, 20] }]\n"
      "[[tables.t.blocks]]\naxes = [{ a = [3] }, { b = ['z'] }]\n");
  const std::vector<FileValues> expected = {{{"a", 1.0}, {"b", "x"}, {"c", 10.0}},
                                            {{"a", 1.0}, {"b", "y"}, {"c", 20.0}},
                                            {{"a", 2.0}, {"b", "x"}, {"c", 10.0}},
                                            {{"a", 2.0}, {"b", "y"}, {"c", 20.0}},
                                            {{"a", 3.0}, {"b", "z"}}};
  EXPECT_EQ(rows, expected);
}

TEST(StudyAxes, LeaveOutWhatWhereSays) {
  const auto rows = rows_of(
      "[[tables.t.blocks]]\naxes = [{ a = [1, 2, 3] }, { b = ['x', 'y'] }]\nwhere = '(b is x) || a > 2'\n");
  EXPECT_EQ(rows.size(), 4U);
}

TEST(StudyAxes, HaveListsAndRanges) {
  const auto rows = rows_of(
      "[lists]\ndegrees = [0, 1]\nlevels = { level = ['i', 'ii'], mass = [1.5, 2.5] }\n"
      "[[tables.t.blocks]]\naxes = ['levels', { d = '$degrees' }, { h = { range = { from = 1e-3, to = 0.1, "
      "count = 3, "
      "spacing = 'log' } } }]\n");
  ASSERT_EQ(rows.size(), 12U);
  EXPECT_EQ(rows[0], (FileValues{{"level", "i"}, {"mass", 1.5}, {"d", 0.0}, {"h", 1e-3}}));
  EXPECT_NEAR(std::get<double>(rows[1].at("h")), 1e-2, 1e-17);
  EXPECT_EQ(rows[11], (FileValues{{"level", "ii"}, {"mass", 2.5}, {"d", 1.0}, {"h", 0.1}}));
}

TEST(Studies, ATextMayHaveColumnsWithin) {
  const Given how{"reconstruction", std::string("least_squares${d}_${extra}"), {}};
  EXPECT_EQ(how.columns(), (std::vector<std::string>{"d", "extra"}));
  EXPECT_EQ(how.with({{"d", 2.0}, {"extra", 4.0}}), text::SetValue("least_squares2_4"));
  const Given file{"scenario", std::string("${name}.toml"), {}};
  EXPECT_EQ(file.with({{"name", "scene"}}), text::SetValue("scene.toml"));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"nam", "name"}, [] {
    Given{"scenario", std::string("${nam}.toml"), {}}.with({{"name", "scene"}});
  }));
  const Given open{"x", std::string("${d"), {}};
  EXPECT_EQ(open.with({{"d", 2.0}}), text::SetValue("${d"));
}

TEST(Studies, WriteTheColumnsThatAreNamedFirst) {
  const Study study =
      of("columns = ['b', 'n']\n[[tables.t.blocks]]\naxes = [{ a = [1] }, { b = [2] }, { c = [3] }]\n"
         "[[tables.own.blocks]]\naxes = [{ a = [1] }]\n[tables.own]\nmetrics = ['double']\ncolumns = "
         "['double']\n"
         "[metrics]\ndouble = { formula = '2*a' }\nn = { of = 'x.y' }\n");
  EXPECT_EQ(study.tables[0].header, (std::vector<std::string>{"b", "n", "a", "c", "double"}));
  EXPECT_EQ(study.tables[1].header, (std::vector<std::string>{"double", "a"}));
}

TEST(Studies, StandInScenariosToo) {
  const test::Scratch folder;
  const auto file =
      folder.write("scene.toml", "[span]\nstop = 1\n[[study.tables.t.blocks]]\naxes = [{ a = [1] }]\n");
  EXPECT_EQ(std::get<std::string>(read(file).scenario.value), "scene.toml");
}

TEST(Studies, ThatAreWrongAreRefusedWithTheirLine) {
  const std::string block = "[[tables.t.blocks]]\naxes = [{ a = [1, 2] }]\n";
  const auto refuses = [](const std::string& text, const std::vector<std::string>& says) {
    EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, says, [&] { of(text); })) << text;
  };
  refuses("", {"tables is missing"});
  refuses("[tables.t]\n", {"table t has no rows"});
  refuses("[[tables.t.blocks]]\naxes = [{ a = [1, 2], b = [1] }]\n",
          {"study.toml:3", "b has 1 values and a has 2"});
  refuses("[[tables.t.blocks]]\naxes = [{ a = [1] }, { a = [2] }]\n", {"a is there twice"});
  refuses("[[tables.t.blocks]]\naxes = [{ 'a b' = [1] }]\n", {"'a b'", "letters"});
  refuses("[[tables.t.blocks]]\naxes = ['lst']\n[lists]\nlist = [1]\n",
          {"study.toml:3", "'lst'", "did you mean 'list'"});
  refuses("[[tables.t.blocks]]\naxes = [{ a = [] }]\n", {"empty"});
  refuses(
      "[[tables.t.blocks]]\naxes = [{ a = { range = { from = 0, to = 1, count = 3, spacing = 'log' } } }]\n",
      {"above 0"});
  refuses("[[tables.t.blocks]]\naxes = [{ a = { range = { from = 0, to = 1, count = 2.5 } } }]\n",
          {"count is 2.5", "whole"});
  refuses("[[tables.t.blocks]]\naxes = [{ a = [1, 1] }]\n", {"the row a = 1 twice"});
  refuses(block + "where = 'b > 1'\n", {"study.toml:4", "'b' is not there"});
  refuses("columns = ['b']\n" + block, {"study.toml:2", "'b' is not there"});
  refuses(block + "[metrics]\na = { of = 'x.y' }\n", {"name of a column"});
  refuses(block + "[metrics]\nm = {}\n",
          {"one of `of`, `signal`, `drift`, `order`, `formula`, `builtin`, `defect` and `energy`"});
  refuses(block + "[metrics]\nm = { of = 'x.y', formula = 'a' }\n", {"has 2 of `of`", "allowed is one"});
  refuses(block + "[metrics]\nm = { of = 'x.y', relative = 'peak' }\n", {"study.toml:5", "no reference"});
  refuses(block + "[metrics]\nm = { formula = 'n*2' }\nn = { of = 'x.y' }\n",
          {"metrics.m.formula: name 'n' is not there"});
  refuses(block + "[metrics]\nm = { formula = '2*' }\n", {"'2*'", "can't be read"});
  refuses(block + "[metrics]\nm = { of = 'x.y', norm = 'largest' }\n",
          {"norm is 'largest'", "max, rms, end, least or most"});
  refuses(block + "[metrics]\nm = { of = 'x.y', from = 2, to = 1 }\n", {"after metrics.m.from"});
  refuses(block + "[references.r]\nper = ['b']\n", {"references.r.per", "'b' is not there"});
  refuses(block + "[references.r]\nwith = { b = 1 }\n", {"'b' is not there"});
  refuses(block + "[references.r]\nfile = 'x.csv'\nfloor = true\n", {"floor has no meaning"});
  refuses(block + "[references.r]\n[references.s]\n[metrics]\nm = { of = 'x.y' }\n",
          {"against is missing", "r, s"});
  refuses(block + "[lost]\nwhen = '1 +'\n", {"can't be read"});
  refuses(block + "[lost]\nwhen = 'errr > 1'\n[metrics]\nerror = { of = 'x.y' }\n",
          {"study.toml:5: lost.when: name 'errr' is not there; did you mean 'error'?"});
  refuses(block + "[metrics]\nm = { of = 'x.y', scale = '2*b' }\n", {"metrics.m.scale: name 'b'"});
  refuses(block + "[references.none]\nper = ['a']\n", {"name none"});
  refuses(block + "[lsot]\nwhen = '1'\n", {"'lsot'", "did you mean 'lost'"});
}

}  // namespace
}  // namespace tandem::study
