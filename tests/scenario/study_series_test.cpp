// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a study keeps over time, times that it takes, and its charts, from the command line.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::study_series_tests {
namespace {

using charts::CsvTable;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string folder_of_scene = TANDEM_SOURCE_DIR "/scenarios/motor_crank/";

/// Two tables, of which the second has no column `step`.
const std::string study = "scenario = '" + folder_of_scene + R"toml(scene.toml'
[set]
"subsystems.motor.parameters.V" = "$voltage"
"subsystems.linkage.parameters.step" = "$step"
"subsystems.motor.parameters.step" = "$(step/2)"
[[tables.steps.blocks]]
axes = [{ voltage = [50, 100] }, { step = [2e-3, 4e-3, 8e-3] }]
[[tables.times.blocks]]
axes = [{ voltage = [50] }]
[tables.times]
metrics = ["exchanges", "seconds", "share.motor", "real_time_factor"]
[references.fine]
per = ["voltage"]
with = { step = 2.5e-4 }
[metrics]
error = { of = "linkage.speed", norm = "max" }
drift = { drift = "linkage.speed^2", norm = "end" }
exchanges = {}
seconds = { repetitions = 2 }
"share.motor" = {}
real_time_factor = {}
[[keep]]
name = "worst"
table = "steps"
where = "step < 0.005"
most = "error"
per = ["voltage"]
outputs = ["linkage.speed", "motor.torque"]
metrics = ["drift"]
every = 0.01
[[charts]]
name = "speed"
kind = "traces"
table = "steps.series"
panels = "voltage"
y = [["linkage.speed", "linkage.speed.fine"]]
)toml";

class StudySeries : public testing::Test {
 protected:
  Said sweep(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"sweep", "s.toml", "--output", "o"});
    return tandem(folder_, more);
  }
  void write(const std::string& text = study) { folder_.write("s.toml", text); }
  std::filesystem::path file(const std::string& name) const { return folder_.path() / "o" / name; }
  Scratch folder_;
};

TEST_F(StudySeries, KeepsWhatTheRunGivesBesideItsReference) {
  write();
  ASSERT_EQ(sweep().status, 0);
  const Said run = tandem(
      folder_, {"run", folder_of_scene + "scene.toml", "--output", "r", "--set", "record.clock=own", "--set",
                "subsystems.motor.parameters.V=100", "--set", "subsystems.linkage.parameters.step=4e-3",
                "--set", "subsystems.motor.parameters.step=2e-3"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto own = text::TimeTable::read(folder_.path() / "r/results.linkage.csv");
  const auto column = static_cast<std::size_t>(
      std::find(own.names.begin(), own.names.end(), "linkage.speed") - own.names.begin());
  const auto kept = CsvTable::read(file("steps.series.csv"), {"voltage", "step", "kept", "motor.torque"});
  double worst = 0.0, before = -1.0;
  std::size_t row = 0;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    EXPECT_EQ(kept[k].number("step"), 4e-3) << "the largest error below 0.005";
    if (kept[k].number("voltage") != 100.0) continue;
    const double t = kept[k].number("time");
    while (own.times[row] < t) ++row;
    EXPECT_EQ(own.times[row], t);
    EXPECT_EQ(kept[k].number("linkage.speed"), own.columns[column][row]);
    EXPECT_EQ(kept[k].number("drift"),
              std::pow(own.columns[column][row], 2) - std::pow(own.columns[column][0], 2));
    EXPECT_TRUE(before < 0.0 || t - before > 0.01 * (1.0 - 1e-8)) << t;
    before = t;
    worst = std::max(worst, std::abs(kept[k].number("linkage.speed") - kept[k].number("linkage.speed.fine")));
  }
  const auto table = CsvTable::read(file("steps.csv"), {"error"});
  EXPECT_LE(worst, table[4].number("error"));
  EXPECT_GT(worst, 0.5 * table[4].number("error"));
}

TEST_F(StudySeries, IsTheSameAfterResuming) {
  write();
  ASSERT_EQ(sweep().status, 0);
  const std::string whole = read_text(file("steps.series.csv")), table = read_text(file("steps.csv"));
  std::filesystem::remove(file("steps.series.csv"));
  const Said again = sweep({"--resume", "--threads", "2"});
  EXPECT_NE(again.out.find("7 rows, 7 kept"), std::string::npos) << again.out;
  EXPECT_EQ(read_text(file("steps.series.csv")), whole);
  EXPECT_EQ(read_text(file("steps.csv")), table);
}

TEST_F(StudySeries, TimesAreInTheTableThatNamesThem) {
  write();
  ASSERT_EQ(sweep().status, 0);
  EXPECT_EQ(read_text(file("steps.csv")).find("seconds"), std::string::npos);
  const auto times = CsvTable::read(file("times.csv"), {"seconds", "seconds.processor"});
  EXPECT_GT(times[0].number("seconds"), 0.0);
  EXPECT_GT(times[0].number("share.motor"), 0.0);
  EXPECT_LT(times[0].number("share.motor"), 1.0);
  EXPECT_GT(times[0].number("real_time_factor"), 0.0);
}

TEST_F(StudySeries, ATableWithoutAColumnLeavesItsKeysAlone) {
  write();
  ASSERT_EQ(sweep({"--table", "times"}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(file("steps.csv"))) << "it was not asked for";
  const Said run = tandem(folder_, {"run", folder_of_scene + "scene.toml", "--output", "r", "--set",
                                    "subsystems.motor.parameters.V=50"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto exchanges = CsvTable::read(file("times.csv"), {"exchanges"})[0].text("exchanges");
  const std::string about = read_text(folder_.path() / "r/machine.json");
  std::size_t all = 0;
  for (std::size_t at = 0; (at = about.find("\"exchanges\": ", at)) != std::string::npos; at += 13)
    all += std::stoul(about.substr(at + 13));
  EXPECT_EQ(exchanges, std::to_string(all)) << about;
}

TEST_F(StudySeries, ItsChartsAreDrawn) {
  write();
  ASSERT_EQ(sweep().status, 0);
  const Said said = tandem(folder_, {"chart", "s.toml", "--results", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(read_text(file("speed.svg")).find("linkage.speed [rad/s]"), std::string::npos);
}

TEST_F(StudySeries, BadOnesAreRefusedByLine) {
  const auto refused = [this](const std::string& from, const std::string& to, const std::string& why) {
    std::string text = study;
    text.replace(text.find(from), from.size(), to);
    write(text);
    const Said said = sweep();
    EXPECT_EQ(said.status, 2) << to;
    EXPECT_NE(said.err.find(why), std::string::npos) << why << " is not in " << said.err;
  };
  refused("\"$step\"", "\"$stop\"",
          "s.toml:4: set.subsystems.linkage.parameters.step: column 'stop' is not there");
  refused("most = \"error\"", "most = \"eror\"",
          "keep[0].most: metric 'eror' is not there; did you mean 'error'?");
  refused("most = \"error\"", "most = \"error\"\nleast = \"error\"", "keep[0].most has no meaning");
  refused("table = \"steps\"\nwhere", "table = \"stops\"\nwhere",
          "keep[0].table: table 'stops' is not there");
  refused("outputs = [\"linkage.speed\", \"motor.torque\"]", "outputs = []", "keep[0].outputs is missing");
  refused("metrics = [\"drift\"]", "metrics = [\"error\"]",
          "metric with a signal or a drift 'error' is not there");
  refused("[[\"linkage.speed\"", "[[\"linkage.sped\"", "charts.speed: column 'linkage.sped' is not there");
  refused("repetitions = 2", "repetitions = 0.5", "a whole number from 1 to 1000");
  refused("\"share.motor\" = {}", "\"share.engine\" = {}", "metric 'share.motor' is not there");
  refused("\"motor.torque\"]", "\"motor.torqe\"]", "output 'motor.torqe' is not there");
}

}  // namespace
}  // namespace tandem::study_series_tests
