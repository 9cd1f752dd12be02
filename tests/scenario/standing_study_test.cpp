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

/// How many steps a cycle has is a parameter that the scenario leaves out.
TEST_F(StandingStudy, CutsStepsByAParameterThatHasItsUsualValue) {
  const std::string file = std::string(TANDEM_SOURCE_DIR) + "/scenarios/two_mass/force_plain.toml";
  const Said said = tandem(folder_, {"sweep", file, "--set", "span.stop=5", "--output", "x"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("steps x 2: "), std::string::npos) << said.out;
}

/// What is held has no reconstruction, and has company in one input.
TEST_F(StandingStudy, VariesOfOneInputWhatIsNotHeld) {
  folder_.write("c.toml",
                "[inputs]\nx = { unit = 'm' }\n[blocks]\n"
                "e = { kind = 'sample', input = 'x', period = 0.05, offset = 0.05 }\n"
                "f = { kind = 'gain', input = 'e', gain = -2 }\n[outputs]\nf = { unit = 'N' }\n");
  folder_.write("m.toml",
                "[inputs]\nf = { unit = 'N' }\n[blocks]\n"
                "a = { kind = 'sum', inputs = ['f', 'x', 'v'], gains = [1, -40, -0.5] }\n"
                "v = { kind = 'integrator', input = 'a' }\n"
                "x = { kind = 'integrator', input = 'v', initial = 0.1 }\n[outputs]\nx = { unit = 'm' }\n");
  folder_.write("n.toml",
                "[inputs]\nx = { unit = 'm' }\n[blocks]\n"
                "f = { kind = 'sum', inputs = ['z', 'x'], gains = [30, -30] }\n"
                "a = { kind = 'gain', input = 'f', gain = -1 }\nv = { kind = 'integrator', input = 'a' }\n"
                "z = { kind = 'integrator', input = 'v' }\n[outputs]\nf = { unit = 'N' }\n");
  const std::string rk4 = "parameters = { integrator = 'rk4', step = ";
  folder_.write("sum.toml",
                "[subsystems.m]\nsource = 'diagram:m.toml'\n" + rk4 + "1e-2 }\n" +
                    "[subsystems.n]\nsource = 'diagram:n.toml'\n" + rk4 + "5e-3 }\n" +
                    "[subsystems.c]\nsource = 'diagram:c.toml'\n"
                    "[[connections]]\nfrom = 'c.f'\nto = 'm.f'\nadd = true\n"
                    "[[connections]]\nfrom = 'n.f'\nto = 'm.f'\nadd = true\nreconstruction = 'lagrange2'\n"
                    "[[connections]]\nfrom = 'm.x'\nto = 'n.x'\nreconstruction = 'lagrange1'\n"
                    "[[connections]]\nfrom = 'm.x'\nto = 'c.x'\nreconstruction = 'lagrange1'\n"
                    "[coordination]\nschedule = 'slowest-first'\n[span]\nstop = 1\n"
                    "[judge]\nquantity = 'm.x'\ntolerance = 1e-3\n");
  EXPECT_EQ(tandem(folder_, {"sweep", "sum.toml", "--output", "x"}).status, 0);
  const Said said = tandem(folder_, {"advise", "sum.toml", "--output", "a"});
  EXPECT_EQ(said.status, 0) << said.err;
  const std::string lines = read_text(folder_.path() / "a/advice.toml");
  EXPECT_NE(lines.find("from = \"n.f\"\nto = \"m.f\"\nadd = true\nreconstruction = "), std::string::npos)
      << lines;
  EXPECT_EQ(lines.find("c.f"), std::string::npos) << lines;
}

TEST_F(StandingStudy, OfAScenarioThatItCanNotSweepSaysWhy) {
  const auto refused = [&](const std::string& scenario, const std::string& why) {
    folder_.write("ring.toml", scenario);
    const Said said = tandem(folder_, {"sweep", "ring.toml", "--output", "x"});
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find(why), std::string::npos) << said.err;
  };
  refused("[subsystems.a]\nsource = \"builtin:two_mass.both\"\n[span]\nstop = 1\n", "has no connection");
}

/// It compares with the same steps of that one, and with shorter ones of the others.
TEST_F(StandingStudy, LeavesAnOwnStepThatNoParameterMakes) {
  folder_.write("lag.toml",
                "[inputs]\nu = { unit = 'm' }\n[blocks]\ny = { kind = 'lag', input = 'u', time = 0.2 }\n"
                "[outputs]\ny = { unit = 'm' }\n");
  folder_.write(
      "ring.toml",
      "[subsystems.a]\nsource = \"lib:" TANDEM_FAULTY_LIBRARY
      "?entry=without_a_fault\"\n"
      "[subsystems.b]\nsource = \"diagram:lag.toml\"\nparameters = { step = 0.01, integrator = \"rk4\" }\n"
      "[[connections]]\nfrom = \"a.x\"\nto = \"b.u\"\nreconstruction = \"lagrange1\"\n"
      "[coordination]\nschedule = \"slowest-first\"\n[span]\nstop = 1\n");
  const Said said = tandem(folder_, {"sweep", "ring.toml", "--output", "x"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("How far the reference itself is off is not known"), std::string::npos) << said.out;
  const Said plan = tandem(folder_, {"sweep", "ring.toml", "--dry-run"});
  EXPECT_NE(plan.out.find("schemes.csv: 32 rows"), std::string::npos) << plan.out;
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
