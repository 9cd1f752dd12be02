// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A scenario without a study is swept by the standing one; results of any runs are laid over each other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::standing_study_tests {
namespace {

using charts::CsvTable;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

/// A first-order lag, and three of them in a ring.
const std::string lag = R"toml([parameters]
T = { value = 0.5, unit = "s" }
[inputs]
u = { unit = "1" }
[outputs]
y = { unit = "1" }
[blocks]
e = { kind = "sum", inputs = ["u", "y"], gains = [1, -1] }
k = { kind = "product", inputs = ["e", "$(1/T)"] }
y = { kind = "integrator", input = "k", initial = 1.0 }
)toml";
const std::string ring = R"toml([subsystems.a]
source = "diagram:lag.toml"
parameters = { T = 0.05, step = 2e-3 }
[subsystems.b]
source = "diagram:lag.toml"
parameters = { T = 0.3, step = 1e-2 }
[subsystems.c]
source = "diagram:lag.toml"
parameters = { T = 1.0, step = 2e-2 }
[[connections]]
from = "a.y"
to = "b.u"
reconstruction = "lagrange1"
[[connections]]
from = "b.y"
to = "c.u"
reconstruction = "lagrange1"
[[connections]]
from = "c.y"
to = "a.u"
gain = -4.0
reconstruction = "lagrange1"
[span]
stop = 4.0
)toml";
const std::string judge = "[judge]\nquantity = \"c.y\"\ntolerance = 0.002\n";

class StandingStudy : public testing::Test {
 protected:
  StandingStudy() { folder_.write("lag.toml", lag); }
  CsvTable swept(const std::string& scenario) {
    folder_.write("ring.toml", scenario);
    said_ = tandem(folder_, {"sweep", "ring.toml", "--output", "o"});
    EXPECT_EQ(said_.status, 0) << said_.err;
    return CsvTable::read(folder_.path() / "o/schemes.csv", {"error", "exchanges", "own_steps"});
  }
  Scratch folder_;
  Said said_{};
};

TEST_F(StandingStudy, TriesEverySchemeAndSaysWhichIsCheapest) {
  const CsvTable table = swept(ring + judge);
  ASSERT_EQ(table.size(), 96U);
  std::vector<std::tuple<double, double, double, std::string>> within;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    EXPECT_EQ(row.text("status"), row.text("note").empty() ? "ok" : "refused") << row.text("note");
    if (row.text("status") != "ok") continue;
    EXPECT_EQ(row.number("error"), row.number("c_y_error") / 0.002);
    EXPECT_EQ(row.number("own_steps"), row.number("steps.a") + row.number("steps.b") + row.number("steps.c"));
    if (row.number("error") <= 1.0)
      within.emplace_back(
          row.number("exchanges"), row.number("own_steps"), row.number("error"),
          row.text("schedule") + ", " + row.text("reconstruction") + ", steps x " + row.text("steps") + ": ");
  }
  ASSERT_FALSE(within.empty());
  EXPECT_NE(said_.out.find(fmt::format("{} of 60 rows that ran are within", within.size())),
            std::string::npos)
      << said_.out;
  EXPECT_NE(
      said_.out.find("Cheapest of these is " + std::get<3>(*std::min_element(within.begin(), within.end()))),
      std::string::npos)
      << said_.out;
}

TEST_F(StandingStudy, ItsErrorsFallAsTheStepsDo) {
  const CsvTable table = swept(ring + judge);
  const auto error = [&](std::size_t scheme, std::size_t step) {
    return table[3 * scheme + step].number("error");
  };
  for (const auto& [scheme, order] :
       {std::pair(0U, 1.0), std::pair(1U, 2.0)}) {  // slowest-first, degree 0 and 1
    EXPECT_NEAR(std::log2(error(scheme, 1) / error(scheme, 0)), order, 0.3) << scheme;
    EXPECT_NEAR(std::log2(error(scheme, 2) / error(scheme, 1)), order, 0.3) << scheme;
  }
}

TEST_F(StandingStudy, IsJudgedAsTheCommandLineSays) {
  folder_.write("ring.toml", ring + judge);
  ASSERT_EQ(tandem(folder_, {"sweep", "ring.toml", "--output", "o", "--set", "judge.tolerance=0.004"}).status,
            0);
  const CsvTable table = CsvTable::read(folder_.path() / "o/schemes.csv", {});
  EXPECT_EQ(table[0].number("error"), table[0].number("c_y_error") / 0.004);
}

TEST_F(StandingStudy, WithoutAJudgeEveryConnectedOutputCounts) {
  const CsvTable table = swept(ring);
  const auto row = table[0];
  const double largest =
      std::max({row.number("a_y_error"), row.number("b_y_error"), row.number("c_y_error")});
  EXPECT_DOUBLE_EQ(row.number("error"), largest / 0.01);
}

TEST_F(StandingStudy, IsToldAndDrawn) {
  swept(ring + judge);
  const Said plan = tandem(folder_, {"sweep", "ring.toml", "--dry-run"});
  EXPECT_NE(plan.out.find("schemes.csv: 96 rows"), std::string::npos) << plan.out;
  const Said said = tandem(folder_, {"chart", "ring.toml", "--results", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "o/schemes_work.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "o/schemes_map.svg"));
}

/// Four connections are added in one input.
TEST_F(StandingStudy, OfInputsThatAreSumsSweepsThemTogether) {
  const Said said =
      tandem(folder_, {"sweep", std::string(TANDEM_SOURCE_DIR) + "/scenarios/oscillator/udc.toml", "--set",
                       "span.stop=0.1", "--output", "x", "--table", "schemes"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("96 rows, 63 ok, 33 refused"), std::string::npos) << said.out;
}

TEST_F(StandingStudy, OfAScenarioThatItCanNotSweepSaysWhy) {
  const auto refused = [&](const std::string& scenario, const std::string& why) {
    folder_.write("ring.toml", scenario);
    const Said said = tandem(folder_, {"sweep", "ring.toml", "--output", "x"});
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find(why), std::string::npos) << said.err;
  };
  refused("[subsystems.a]\nsource = \"builtin:two_mass.both\"\n[span]\nstop = 1\n", "has no connection");
  std::string two_mass = read_text(test::two_mass_file("two_mass.toml"));
  two_mass.replace(two_mass.find("steps_per_cycle"), std::string("steps_per_cycle").size(), "phase1");
  refused(two_mass, "subsystem 'fast' has an own step of 0.01 s");
}

TEST(PlottedResults, AreLaidOverEachOther) {
  const Scratch folder;
  for (const char* how : {"lagrange0", "lagrange3"})
    ASSERT_EQ(
        tandem(folder, {"run", test::two_mass_file("two_mass.toml"), "--no-reference", "--output", how,
                        "--set", "span.stop=2", "--set", std::string("connections.reconstruction=") + how})
            .status,
        0);
  const Said said = tandem(folder, {"chart", "lagrange0", "lagrange3", "--plot", "fast.x1,slow.x2"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table =
      CsvTable::read(folder.path() / "lagrange0/plot.csv", {"results", "time", "fast.x1", "slow.x2"});
  EXPECT_EQ(table[0].text("results"), "lagrange0");
  EXPECT_EQ(table[table.size() - 1].text("results"), "lagrange3");
  EXPECT_NE(read_text(folder.path() / "lagrange0/plot.svg").find("fast.x1 [m]"), std::string::npos);
  const Said wrong = tandem(folder, {"chart", "lagrange0", "--plot", "fast.x3"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("column 'fast.x3' is not there"), std::string::npos) << wrong.err;
  EXPECT_EQ(tandem(folder, {"chart", "lagrange0", "lagrange3"}).status, 2);
}

}  // namespace
}  // namespace tandem::standing_study_tests
