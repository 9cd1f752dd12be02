// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// An impulse coupling as a candidate: of advice, of standing studies, and of a scenario that chooses.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scene_run.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::test {
namespace {

/// The two-mass test at ratio 60, where every coupling of samples fails, without a coupling and a fast period.
class ImpulseAdvice : public testing::Test {
 protected:
  ImpulseAdvice() {
    text_ = read_text(two_mass_file("impulse.toml"));
    replace("frequency_ratio = 300.0", "frequency_ratio = 60.0");
    replace("fast_period = 1.0", "");
    replace("stop = 300.0", "stop = 30.0");
  }
  void replace(const std::string& a, const std::string& b) {
    const auto at = text_.find(a);
    ASSERT_NE(at, std::string::npos) << a;
    text_.replace(at, a.size(), b);
  }
  void by_samples() {
    replace("coupling = \"impulse\"", "coupling = \"signals\"");
    for (const char* to : {"to = \"slow.F\"", "to = \"fast.x2\""})
      replace(to, std::string(to) + "\nreconstruction = \"lagrange3\"");
  }
  Said x(const std::vector<std::string>& words) {
    folder_.write("s.toml", text_);
    return tandem(folder_, words);
  }
  std::string text(const std::string& file) { return read_text(folder_.path() / file); }

  Scratch folder_;
  std::string text_;
};

TEST_F(ImpulseAdvice, FindsItWhereSamplesFail) {
  for (const char* coupling : {"coupling = \"impulse\"", "coupling = \"signals\""}) {
    if (coupling == std::string("coupling = \"signals\"")) by_samples();
    const Said said = x({"advise", "s.toml", "--output", "a"});
    ASSERT_EQ(said.status, 0) << said.err;
    const auto at = said.out.find("cheapest within the tolerance:");
    ASSERT_NE(at, std::string::npos) << said.out;
    EXPECT_NE(said.out.find("fastest-first, impulse_stiffness, steps x 2", at), std::string::npos)
        << said.out;
    EXPECT_NE(said.out.find("0.833 of the largest steps a cycle", at), std::string::npos) << said.out;
    EXPECT_TRUE(text("a/advice.toml").starts_with("[coordination]\ncoupling = \"impulse_stiffness\"\n"));
    EXPECT_EQ(text("a/advice.toml").find("[[connections]]"), std::string::npos) << "links have none";
  }
}

/// A mechanism that is not linear runs itself: the mass that it tells and its equations do, the stiffness of its start does not.
TEST_F(ImpulseAdvice, RanksTheKindsOfOneThatRunsItself) {
  const Said said = tandem(
      folder_,
      {"advise", TANDEM_SOURCE_DIR "/scenarios/pushed_pendulum/pushed_pendulum.toml", "--output", "a"});
  ASSERT_EQ(said.status, 0) << said.err;
  std::map<std::string, double> errors;
  const auto table =
      charts::CsvTable::read(folder_.path() / "a/schemes.csv", {"reconstruction", "error", "status"});
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table[k].text("status") == "ok" && table[k].text("reconstruction").starts_with("impulse"))
      errors[table[k].text("reconstruction")] = table[k].number("error");
  EXPECT_LT(errors.at("impulse"), 0.5);
  EXPECT_LT(errors.at("impulse_taylor"), 0.5);
  EXPECT_GT(errors.at("impulse_stiffness"), 1.0);
}

TEST_F(ImpulseAdvice, OfAStandingStudyIsAReferenceAtAnyRatio) {
  for (const char* ratio : {"25", "300"}) {
    const Said said =
        x({"sweep", "s.toml", "--output", "o", "--set", std::string("parameters.frequency_ratio=") + ratio});
    ASSERT_EQ(said.status, 0) << said.err;
    const auto table = charts::CsvTable::read(
        folder_.path() / "o/schemes.csv", {"reconstruction", "steps", "error", "reference_error", "status"});
    std::size_t impulse = 0;
    for (std::size_t k = 0; k < table.size(); ++k) {
      if (table[k].text("reconstruction") != "impulse") continue;
      ++impulse;
      EXPECT_EQ(table[k].text("status"), "ok");
      EXPECT_LT(table[k].number("reference_error"), 0.05) << ratio;
    }
    EXPECT_EQ(impulse, 3U) << said.out;
  }
}

TEST_F(ImpulseAdvice, AScenarioThatChoosesTakesIt) {
  replace("coupling = \"impulse\"", "scheme = \"auto\"");
  text_ += "\n[judge]\nquantity = \"fast.F\"\ntolerance = 0.01\n";
  Said said = x({"run", "s.toml", "--output", "whole"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.err, "coordination.fast_period is 1 s")) << said.err;
  for (const char* taken :
       {"\"coordination.coupling=impulse_stiffness\"", "\"coordination.fast_period=1.0\""})
    EXPECT_TRUE(contains(text("whole/results.json"), taken));
  ASSERT_EQ(x({"run", "s.toml", "--output", "cut", "--checkpoint-every", "7"}).status, 0);
  said = x({"run", "s.toml", "--output", "cut", "--resume", "cut/checkpoint"});
  ASSERT_EQ(said.status, 0) << said.err;
  for (const char* name : {"results.csv", "results.json"})
    EXPECT_EQ(text(std::string("cut/") + name), text(std::string("whole/") + name));
  said = x({"run", "s.toml", "--set", "coordination.coupling=signals"});
  EXPECT_TRUE(contains(said.out, "auto takes ")) << said.err;
  EXPECT_FALSE(contains(said.out, "impulse")) << said.out;
}

/// Beside the exact motion. Of the surrogate's outputs the slow side's stand for the true ones.
TEST_F(ImpulseAdvice, AnEstimateIsTheTrueError) {
  text_ += "\n[judge]\nquantity = \"slow_surrogate.displacement\"\ntolerance = 0.01\n";
  for (const char* ratio : {"60", "300"}) {
    const std::string set = std::string("parameters.frequency_ratio=") + ratio;
    const SceneRun exact(two_mass_file("exact.toml"), {set, "span.stop=100"});
    const Said said =
        x({"run", "s.toml", "--estimate", "--output", "o", "--set", set, "--set", "span.stop=100"});
    ASSERT_EQ(said.status, 0) << said.err;
    const auto found =
        charts::CsvTable::read(folder_.path() / "o/results.csv", {"slow_surrogate.displacement"});
    const auto& wanted = exact.column("exact.x2");
    double largest = 0.0, peak = 0.0;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      largest = std::max(largest, std::abs(found[k].number("slow_surrogate.displacement") - wanted[k]));
      peak = std::max(peak, std::abs(wanted[k]));
    }
    const std::string head = "estimate: slow_surrogate.displacement is off by ";
    const auto at = said.out.find(head);
    ASSERT_NE(at, std::string::npos) << said.out;
    EXPECT_NEAR(std::stod(said.out.substr(at + head.size())), largest / peak, 0.05 * largest / peak) << ratio;
  }
}

TEST_F(ImpulseAdvice, TellsWhyItIsNotTried) {
  by_samples();
  replace("displacement = \"slow.x2\"", "displacement = \"slow.v2\"");
  const Said said = x({"advise", "s.toml", "--output", "a"});
  EXPECT_TRUE(contains(said.out, "no impulse coupling is tried: ")) << said.out << said.err;
}

/// A damper whose rate does not come by the link: no impulse row, and no reference that runs away.
TEST_F(ImpulseAdvice, IsNotTriedWhereARateGoesPastTheSurrogate) {
  folder_.write("fast.toml", R"toml(
name = "fast"
[inputs]
x = { unit = "m" }
w = { unit = "m/s" }
[outputs]
F = { unit = "N" }
[blocks]
stretch = { kind = "sum", inputs = ["x1", "x"], gains = [1, -1] }
speed = { kind = "sum", inputs = ["v1", "w"], gains = [1, -1] }
spring = { kind = "gain", input = "stretch", gain = 1 }
damper = { kind = "gain", input = "speed", gain = 0.01 }
F = { kind = "sum", inputs = ["spring", "damper"] }
a1 = { kind = "gain", input = "F", gain = -39 }
v1 = { kind = "integrator", input = "a1", initial = 0 }
x1 = { kind = "integrator", input = "v1", initial = 11 }
[run]
step = 0.01
)toml");
  replace("builtin:two_mass.fast_force", "diagram:fast.toml");
  replace("[parameters] # of every subsystem\nfrequency_ratio = 60.0\nsteps_per_cycle = 100", "");
  replace("builtin:two_mass.slow_force\"",
          "builtin:two_mass.slow_force\"\nparameters = { frequency_ratio = 60 }");
  replace("to = \"fast.x2\"",
          "to = \"fast.x\"\n\n[[connections]]\nfrom = \"slow.v2\"\nto = \"fast.w\"\n"
          "reconstruction = \"lagrange1\"");
  const Said said = x({"advise", "s.toml", "--output", "a"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "connection from slow.v2 to fast.w: it goes past the surrogate"))
      << said.out;
  EXPECT_FALSE(contains(said.out, "impulse, steps")) << said.out;
}

TEST_F(ImpulseAdvice, SaysWhereAFastPeriodIsToBeStated) {
  replace("builtin:two_mass.fast_force", "diagram:gear.toml");
  folder_.write("gear.toml", read_text(TANDEM_SOURCE_DIR "/scenarios/rattling/gear.toml"));
  replace("steps_per_cycle = 100", "");
  const Said said = x({"run", "s.toml"});
  EXPECT_EQ(said.status, 2) << said.err;
  for (const char* words :
       {"coordination.fast_period is not stated, and can't be found", "'fast'", "above 0 [s]"})
    EXPECT_TRUE(contains(said.err, words)) << said.err;
}

}  // namespace
}  // namespace tandem::test
