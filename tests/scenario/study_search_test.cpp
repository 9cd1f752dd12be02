// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// [[search]] of a study, from the command line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::study_search_tests {
namespace {

using charts::CsvTable;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string head = "scenario = '" TANDEM_SOURCE_DIR R"toml(/scenarios/motor_crank/scene.toml'
[set]
"subsystems.linkage.parameters.step" = "$step"
"subsystems.motor.parameters.step" = "$(step/2)"
"connections.reconstruction" = "$how"
[references.fine]
with = { step = 2.5e-4, how = "lagrange3" }
[metrics]
error = { of = "linkage.speed", norm = "max", relative = "peak" }
exchanges = {}
)toml";

std::string search(const std::string& more) {
  return head +
         "[[search]]\nname = 'largest'\ncolumn = 'step'\naxes = [{ how = ['lagrange0', 'lagrange1'] }]\n" +
         more;
}

class StudySearch : public testing::Test {
 protected:
  CsvTable swept(const std::string& study, const std::string& table) {
    folder_.write("s.toml", study);
    const Said said = tandem(folder_, {"sweep", "s.toml", "--output", "o", "--threads", "2"});
    EXPECT_EQ(said.status, 0) << said.err;
    return CsvTable::read(folder_.path() / "o" / (table + ".csv"), {});
  }
  void refused(const std::string& study, const std::string& why) {
    folder_.write("s.toml", study);
    const Said said = tandem(folder_, {"sweep", "s.toml", "--output", "x"});
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find(why), std::string::npos) << said.err;
  }
  Scratch folder_;
};

TEST_F(StudySearch, FindsTheLargestStepThatIsGoodEnough) {
  const CsvTable found =
      swept(search("from = 5e-4\nto = 0.02\nholds = 'error < 0.005'\nprecision = 0.02\n"), "largest");
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double step = found[k].number("step");
    EXPECT_LT(found[k].number("error"), 0.005);
    const std::string beyond =
        fmt::format("{}[[tables.t.blocks]]\naxes = [{{ how = ['{}'] }}, {{ step = [{}, {}] }}]\n", head,
                    found[k].text("how"), step, step * 1.02);
    const CsvTable rows = swept(beyond, "t");
    EXPECT_EQ(rows[0].text("error"), found[k].text("error"));
    EXPECT_EQ(rows[0].text("exchanges"), found[k].text("exchanges"));
    EXPECT_GE(rows[1].number("error"), 0.005) << "at most 2 % more is too much";
  }
  EXPECT_GT(found[1].number("step"), 1.5 * found[0].number("step")) << "degree 1 beats degree 0";
}

TEST_F(StudySearch, FindsTheSmallestToo) {
  const CsvTable found =
      swept(search("from = 5e-4\nto = 0.02\nfind = 'smallest'\nholds = 'exchanges < 500'\n"), "largest");
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(found[k].number("exchanges"), 500.0);
    EXPECT_NEAR(found[k].number("step"), 0.004, 0.0001);  // two calls each step of the linkage, 1 s
  }
}

TEST_F(StudySearch, EndsWhereThereIsNoNumberBetween) {
  const CsvTable found =
      swept(search("from = 1e-3\nto = 4e-3\nholds = 'step < 0.003'\nprecision = 1e-18\n"), "largest");
  EXPECT_EQ(found[0].number("step"), std::nextafter(0.003, 0.0));
}

TEST_F(StudySearch, SaysWhereItHoldsNowhereOrEverywhere) {
  const CsvTable nowhere = swept(search("from = 1e-3\nto = 0.02\nholds = 'error < 1e-9'\n"), "largest");
  EXPECT_EQ(nowhere[0].text("step"), "");
  EXPECT_EQ(nowhere[0].text("note"), "it does not hold at 0.001");
  const CsvTable everywhere = swept(search("from = 1e-3\nto = 2e-3\nholds = 'error < 1'\n"), "largest");
  EXPECT_EQ(everywhere[0].number("step"), 2e-3);
  EXPECT_EQ(everywhere[0].text("note"), "it holds at 0.002 too");
}

TEST_F(StudySearch, AScanFindsTheFirstValueThatFailsWhereBisectionPassesOverIt) {
  const std::string holds =
      "from = 1e-3\nto = 0.016\nholds = 'step < 0.0025 || step > 0.004'\nprecision = 1e-6\n";
  EXPECT_EQ(swept(search(holds), "largest")[0].number("step"), 0.016);
  EXPECT_NEAR(swept(search(holds + "scan = 1.1\n"), "largest")[0].number("step"), 0.0025, 3e-9);
  const std::string down =
      "from = 1e-3\nto = 0.016\nfind = 'smallest'\nprecision = 1e-6\n"
      "holds = 'step > 0.004 || step < 0.0025'\nscan = 1.1\n";
  EXPECT_NEAR(swept(search(down), "largest")[0].number("step"), 0.004, 5e-9);
}

TEST_F(StudySearch, NumbersOfItsOwnStandWhereItHoldsNowhereOrEverywhere) {
  const std::string both = "nowhere = 0\neverywhere = inf\nscan = 1.5\n";
  const CsvTable nowhere =
      swept(search("from = 1e-3\nto = 2e-3\nholds = 'error < 1e-9'\n" + both), "largest");
  EXPECT_EQ(nowhere[0].text("step"), "0");
  const CsvTable everywhere =
      swept(search("from = 1e-3\nto = 2e-3\nholds = 'error < 1'\n" + both), "largest");
  EXPECT_EQ(everywhere[0].text("step"), "inf");
  EXPECT_EQ(everywhere[0].text("note"), "it holds at 0.002 too");
}

TEST_F(StudySearch, TheColumnsOfTheStudyComeFirst) {
  const CsvTable found = swept(
      "columns = ['how', 'exchanges', 'step']\n" + search("from = 1e-3\nto = 2e-3\nholds = 'error < 1'\n"),
      "largest");
  EXPECT_EQ(found.names(), (std::vector<std::string>{"how", "exchanges", "step", "error", "status", "note"}));
}

TEST_F(StudySearch, IsTheSameWithOneThreadAndAfterResuming) {
  const std::string study = search("from = 5e-4\nto = 0.02\nholds = 'error < 0.005'\n");
  swept(study, "largest");
  const std::string two = read_text(folder_.path() / "o/largest.csv");
  ASSERT_EQ(tandem(folder_, {"sweep", "s.toml", "--output", "o", "--threads", "1"}).status, 0);
  EXPECT_EQ(read_text(folder_.path() / "o/largest.csv"), two);
  const Said again = tandem(folder_, {"sweep", "s.toml", "--output", "o", "--resume"});
  EXPECT_NE(again.out.find("2 rows, 2 kept"), std::string::npos) << again.out;
}

TEST_F(StudySearch, BadOnesAreRefused) {
  const std::string good = "from = 5e-4\nto = 0.02\nholds = 'error < 0.005'\n";
  refused(search("from = 5e-4\nto = 1e-4\nholds = 'error < 1'\n"), "a number above search[0].from");
  refused(search("from = 5e-4\nto = 0.02\n"), "search[0].holds is missing");
  refused(search("from = 5e-4\nto = 0.02\nholds = 'eror < 1'\n"),
          "name 'eror' is not there; did you mean 'error'?");
  refused(search(good + "find = 'best'\n"), "search[0].find is 'best'");
  refused(search(good + "scan = 0.9\n"), "search[0].scan is the number 0.9; allowed is a factor above 1");
  refused(search(good + "nowhere = 'none'\n"),
          "search[0].nowhere is the text 'none'; allowed is a number, or inf");
  refused("columns = ['hwo']\n" + search(good), "columns: column or metric 'hwo' is not there");
  refused(search(good + "frm = 1\n"), "unknown key of [search[0]] 'frm'; did you mean 'from'?");
  refused(search(good) + "[[keep]]\nname = 'k'\noutputs = ['linkage.speed']\n", "keep[0] has no table");
  refused(search(good) + "[[tables.largest.blocks]]\naxes = [{ how = ['lagrange0'] }]\n",
          "two tables have the name largest");
}

}  // namespace
}  // namespace tandem::study_search_tests
