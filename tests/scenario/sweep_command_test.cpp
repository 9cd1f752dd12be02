// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "background.hpp"
#include "command.hpp"
#include "engine_linkage/sweep.hpp"

namespace tandem {
namespace {

using test::Background;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string study = TANDEM_SOURCE_DIR "/scenarios/motor_crank/study.toml";

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SweepCommand, RefusesALevelThatTheKartHasNot) {
  const Scratch folder;
  const Said said = tandem(folder, {"sweep", "kart", "--level", "flat"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("spatial_scalar_spin"), std::string::npos) << said.err;
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
  std::filesystem::create_directories(folder.path() / "o/schemes.csv.part");
  const Said said = tandem(folder, {"sweep", study, "--output", "o"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("schemes.csv.part' can't be written: File exists"), std::string::npos) << said.err;
}

TEST(SweepCommand, AFileInPlaceOfTheFolderIsStatusTwo) {
  const Scratch folder;
  folder.write("o", "");
  const Said said = tandem(folder, {"sweep", study, "--output", "o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("folder 'o' can't be made: "), std::string::npos) << said.err;
}

}  // namespace
}  // namespace tandem
