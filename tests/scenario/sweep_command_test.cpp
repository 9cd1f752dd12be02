// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "background.hpp"
#include "command.hpp"
#include "engine_linkage/sweep.hpp"
#include "two_mass/sweep.hpp"

namespace tandem {
namespace {

using test::Background;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SweepCommand, RefusesALevelThatTheKartHasNot) {
  const Scratch folder;
  const Said said = tandem(folder, {"sweep", "kart", "--level", "flat"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("spatial_scalar_spin"), std::string::npos) << said.err;
}

TEST(SweepCommand, InterruptedKeepsItsRowsAndIsResumed) {
  const Scratch folder;
  const auto sweep = folder.path() / "o";
  Background first(folder, {"sweep", "two_mass", "--table-only", "--output", "o"});
  ASSERT_TRUE(first.wait_for_file(sweep / "sweep.json")) << first.err();
  EXPECT_EQ(first.end_by(SIGINT), 1);
  EXPECT_NE(first.err().find("interrupted; "), std::string::npos) << first.err();
  EXPECT_NE(first.err().find("--resume goes on from there"), std::string::npos) << first.err();
  const std::string kept = read_text(sweep / "sweep.csv");
  const Said refused = tandem(folder, {"chart", "two_mass", "--results", "o"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("is missing; 'tandem sweep two_mass --output o --resume' writes it"),
            std::string::npos)
      << refused.err;

  const Said said = tandem(folder, {"sweep", "two_mass", "--table-only", "--resume", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const std::string all = read_text(sweep / "sweep.csv");
  const auto cases = two_mass::sweep_ratios().size() * two_mass::sweep_schemes(false).size();
  EXPECT_LT(lines_of(kept), cases + 1);
  EXPECT_EQ(lines_of(all), cases + 1);
  EXPECT_EQ(lines_of(read_text(sweep / "sweep_timings.csv")), cases + 1);
  for (std::size_t begin = 0, end; (end = kept.find('\n', begin)) != std::string::npos; begin = end + 1)
    EXPECT_NE(all.find(kept.substr(begin, end + 1 - begin)), std::string::npos);
  const two_mass::Case one{{"fastest-first", "lagrange3", "mean"}, 30.7};
  EXPECT_NE(all.find(two_mass::sweep_key(one) + "," + two_mass::sweep_cells(two_mass::run_case(one)) + "\n"),
            std::string::npos);
}

TEST(SweepCommand, InterruptedLeavesTheRowsOfTheLinkageThatItHas) {
  const Scratch folder;
  const auto table = folder.path() / "o/equal_steps.csv";
  Background sweep(folder, {"sweep", "engine_linkage", "--table-only", "--output", "o", "--engine-linkage",
                            TANDEM_SOURCE_DIR "/scenarios/engine_linkage"});
  ASSERT_TRUE(sweep.wait_for_file(table)) << sweep.err();
  EXPECT_EQ(sweep.end_by(SIGINT), 1);
  const auto rows = lines_of(read_text(table)) - 1;
  const std::string said = fmt::format("interrupted; the first {} of {} rows are in o/equal_steps.csv", rows,
                                       engine_linkage::equal_step_cases().size());
  EXPECT_NE(sweep.err().find(said), std::string::npos) << said << " is not in: " << sweep.err();
}

TEST(SweepCommand, ATableThatCanNotBeWrittenIsStatusOneWithItsReason) {
  const Scratch folder;
  std::filesystem::create_directories(folder.path() / "o/sweep.csv.part");
  Background sweep(folder, {"sweep", "two_mass", "--table-only", "--output", "o"});
  ASSERT_TRUE(sweep.wait_for_file(folder.path() / "o/sweep.json"));
  EXPECT_EQ(sweep.end_by(SIGINT), 1);
  EXPECT_NE(sweep.err().find("sweep.csv.part' can't be written: File exists"), std::string::npos)
      << sweep.err();
}

TEST(SweepCommand, AFileInPlaceOfTheFolderIsStatusTwo) {
  const Scratch folder;
  folder.write("o", "");
  const Said said = tandem(folder, {"sweep", "two_mass", "--output", "o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("folder 'o' can't be made: "), std::string::npos) << said.err;
}

}  // namespace
}  // namespace tandem
