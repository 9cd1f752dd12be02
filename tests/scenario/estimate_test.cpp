// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// record.indicators = "estimate", from the command line.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::estimate_tests {
namespace {

using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;
using test::two_mass_file;
using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

nlohmann::json json_of(const Scratch& folder, const std::string& file) {
  return nlohmann::json::parse(read_text(folder.path() / file));
}

const std::vector<double>& column(const text::TimeTable& table, const std::string& name) {
  return table.columns.at(static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) -
                                                   table.names.begin()));
}

/// Largest difference of fast.x1 from the exact motion, at the fast side's steps.
double true_error(const Scratch& folder, const Words& ratio) {
  const Said said = tandem(folder, Words{"run", two_mass_file("exact.toml"), "--output", "exact"} + ratio);
  EXPECT_EQ(said.status, 0) << said.err;
  const auto found = text::TimeTable::read(folder.path() / "o/results.csv"),
             exact = text::TimeTable::read(folder.path() / "exact/results.csv");
  const auto &x = column(found, "fast.x1"), &y = column(exact, "exact.x1");
  EXPECT_EQ(x.size(), y.size());
  double most = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::abs(x[k] - y[k]));
  return most;
}

/// Own steps as the difference of two times far from 0 were another step, and the end of the run another one.
TEST(Estimate, IsTheSameWhereverTimeBegins) {
  double first = 0.0;
  for (const double start : {0.0, 1.3, 17.3, -4.2, 1000.1}) {
    const Scratch folder;
    const Said said =
        tandem(folder, {"run", TANDEM_SOURCE_DIR "/scenarios/oscillator/udc.toml", "--no-reference",
                        "--output", "o", "--estimate", "--set", "span.start=" + std::to_string(start),
                        "--set", "span.stop=" + std::to_string(start + 10.0)});
    ASSERT_EQ(said.status, 0) << said.err;
    const auto told = json_of(folder, "o/results.json")["indicators"]["estimates"];
    ASSERT_TRUE(told.contains("estimate(side1.x)")) << start << said.out;
    const double largest = told["estimate(side1.x)"]["largest"];
    if (start == 0.0) first = largest;
    EXPECT_NEAR(largest, first, 1e-5 * first) << start;
  }
}

TEST(Estimate, TellsTheErrorOfTheJudgedOutputAndChangesNoBit) {
  for (const char* ratio : {"4", "9.3", "25", "57.3"}) {
    const Words of = {"--set", std::string("parameters.frequency_ratio=") + ratio};
    const Words run =
        Words{"run", two_mass_file("two_mass.toml"), "--no-reference", "--set", "record.clock=fast"} + of;
    const Scratch folder;
    ASSERT_EQ(tandem(folder, run + Words{"--output", "plain"}).status, 0);
    const Said said = tandem(folder, run + Words{"--output", "o", "--estimate"});
    ASSERT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(read_text(folder.path() / "o/results.csv"), read_text(folder.path() / "plain/results.csv"));
    const auto told = json_of(folder, "o/results.json")["indicators"]["estimates"]["estimate(fast.x1)"];
    const double error = true_error(folder, of);
    EXPECT_NEAR(told["largest"].get<double>(), error, 0.02 * error) << ratio;
    EXPECT_NE(said.out.find("estimate: fast.x1 is off by "), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("of its peak, of which 0.15 is allowed"), std::string::npos) << said.out;
    EXPECT_GT(json_of(folder, "o/machine.json")["seconds_of_the_estimate"].get<double>(), 0.0);
    const auto windows = text::TimeTable::read(folder.path() / "o/indicators.csv");
    const auto& course = column(windows, "estimate(fast.x1)");
    EXPECT_EQ(*std::max_element(course.begin(), course.end()), told["largest"].get<double>()) << ratio;
  }
}

TEST(Estimate, GoesOnFromACheckpoint) {
  const Words run = {"run", two_mass_file("two_mass.toml"), "--no-reference", "--estimate", "--output"};
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run + Words{"whole"}).status, 0);
  ASSERT_EQ(tandem(folder, run + Words{"cut", "--checkpoint-every", "30"}).status, 0);
  const Said said = tandem(folder, run + Words{"cut", "--resume", "cut/checkpoint"});
  ASSERT_EQ(said.status, 0) << said.err;
  for (const char* file : {"results.csv", "results.json", "indicators.csv"})
    EXPECT_EQ(read_text(folder.path() / "cut" / file), read_text(folder.path() / "whole" / file)) << file;
}

TEST(Estimate, WhereThereIsNoModelItSaysSo) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", TANDEM_SOURCE_DIR "/scenarios/drive/drive_libraries.toml",
                                    "--estimate", "--no-reference", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("estimate: none; "), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("there is no linear model of diagram:load.toml"), std::string::npos) << said.out;
  const auto indicators = json_of(folder, "o/results.json")["indicators"];
  EXPECT_FALSE(indicators.contains("estimates"));
  EXPECT_NE(indicators["no_estimate"].get<std::string>().find("no linear model"), std::string::npos);
}

TEST(Estimate, NeedsAnOutputThatIsJudged) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("exact.toml"), "--estimate", "--output", "o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find(
                "record.indicators is estimate, of the output that [judge] names, and there is no [judge]"),
            std::string::npos)
      << said.err;
}

}  // namespace
}  // namespace tandem::estimate_tests
