// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The kart with its engine, coupled in steps: what its study measures.
#include <gtest/gtest.h>

#include <map>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::kart_study_tests {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

/// The printed run of level ii: its extrema to 0.01 deg. At 10 ms the trapezoidal rule alone errs by 0.010
/// deg with the torque's mean (the period's error of the pitch, (omega h)^2/12).
TEST(KartStudy, ThePlaneAtAHundredEngineStepsErrsAsItsIntegratorDoes) {
  const Scratch folder;
  const std::string where =
      "(level is plane) && ((to_fast is lagrange1) && (to_slow is mean) || (schedule is slowest-first) && "
      "(to_fast is lagrange0) && (to_slow is lagrange0) || (schedule is parallel) && (to_fast is lagrange2) "
      "&& "
      "(to_slow is lagrange1))";
  const Said said = tandem(folder, {"sweep", TANDEM_SOURCE_DIR "/scenarios/kart/study.toml", "--table",
                                    "schemes", "--where", where, "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table = charts::CsvTable::read(folder.path() / "o/schemes.csv", {});
  ASSERT_EQ(table.size(), 3U);
  const auto thesis = table[0], apart = table[1], mean = table[2];
  EXPECT_EQ(thesis.text("schedule"), "slowest-first");
  EXPECT_EQ(mean.text("to_slow"), "mean");
  EXPECT_NEAR(mean.number("integrator_part"), 0.0105, 0.001);
  EXPECT_LT(mean.number("coupling_part"), 0.0025);
  EXPECT_LT(mean.number("max_pitch_difference"),
            mean.number("integrator_part") + mean.number("coupling_part") + 1e-12);
  EXPECT_GT(thesis.number("max_pitch_difference"), 5.0 * mean.number("max_pitch_difference"));
  EXPECT_EQ(mean.text("status"), "ok");
  EXPECT_EQ(apart.text("status"), "unstable");

  const auto series = charts::CsvTable::read(folder.path() / "o/schemes.series.csv", {});
  std::map<std::string, double> least, most;
  std::string gears;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto row = series[k];
    const std::string& kept = row.text("kept");
    if (kept == "wheels") continue;
    EXPECT_EQ(row.text("to_slow"), kept == "worst" ? "lagrange0" : "mean");
    least["better"] = std::min(least["better"], row.number("kart.pitch.better"));
    most["better"] = std::max(most["better"], row.number("kart.pitch.better"));
    if (kept == "worst" && (gears.empty() || gears.back() != row.text("engine.gear")[0]))
      gears += row.text("engine.gear");
  }
  constexpr double degrees = 57.29577951308232;
  EXPECT_NEAR(degrees * least["better"], -2.464, 0.01);
  EXPECT_NEAR(degrees * most["better"], 0.785, 0.01);
  EXPECT_EQ(gears, "1232");
}

TEST(KartStudy, NoRowIsLeftOfALevelThatItHasNot) {
  const Scratch folder;
  const std::string study = TANDEM_SOURCE_DIR "/scenarios/kart/study.toml";
  for (const auto& [where, sentence] :
       {std::pair("(level is flat)", "no row is left where (level is flat)"),
        std::pair("(levle is plane)", "column 'levle' is not there; did you mean 'level'?")}) {
    const Said said = tandem(folder, {"sweep", study, "--where", where, "--dry-run"});
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find(sentence), std::string::npos) << said.err;
  }
}

}  // namespace
}  // namespace tandem::kart_study_tests
