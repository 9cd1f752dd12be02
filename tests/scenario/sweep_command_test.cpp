// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

const std::string study = TANDEM_SOURCE_DIR "/scenarios/motor_crank/study.toml";

TEST(SweepCommand, ATableThatCanNotBeWrittenIsStatusOneWithItsReason) {
  const Scratch folder;
  std::filesystem::create_directories(folder.path() / "o/schemes.csv.part");
  const Said said = tandem(folder, {"sweep", study, "--output", "o"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("schemes.csv' can't be written: there is a folder"), std::string::npos) << said.err;
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
