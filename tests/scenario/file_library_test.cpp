// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Libraries made of files by tandem_add_subsystem_library().
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

using test::contains;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

std::string file_library(const std::string& name) {
  return "subsystems." + name + ".source=lib:" TANDEM_FILE_LIBRARIES "/" + name + "_library.so";
}

/// Half a second of the linkage driven by the engine, with more words of the command.
Said half_a_second(const Scratch& folder, std::vector<std::string> more) {
  std::vector<std::string> words = {"run", TANDEM_SOURCE_DIR "/scenarios/engine_linkage/engine_linkage.toml",
                                    "--no-reference", "--set", "span.stop=0.5"};
  words.insert(words.end(), more.begin(), more.end());
  return tandem(folder, words);
}

TEST(FileLibrary, GivesTheBitsOfTheFileInThisProcess) {
  const Scratch folder;
  ASSERT_EQ(half_a_second(folder, {"--output", "here"}).status, 0);
  const std::string expected = read_text(folder.path() / "here/results.csv");
  const std::vector<std::string> cases[] = {
      {"--set", file_library("engine")},
      {"--set", file_library("linkage")},
      {"--set", file_library("engine"), "--set", file_library("linkage")}};
  for (std::vector<std::string> more : cases) {
    more.insert(more.end(), {"--output", "there"});
    const Said said = half_a_second(folder, more);
    ASSERT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(read_text(folder.path() / "there/results.csv"), expected) << more[1];
  }
}

/// 3 s of the kart, through its first throttle, with either side elsewhere.
TEST(FileLibrary, OfTheKartsPowerTrainAndTheKartInAProcessGiveTheSameBits) {
  const Scratch folder;
  const std::string kart = TANDEM_SOURCE_DIR "/scenarios/kart/";
  const auto results = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"run", kart + "kart.toml", "--set", "span.stop=3", "--output", "o"};
    words.insert(words.end(), more.begin(), more.end());
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 0) << said.err;
    return read_text(folder.path() / "o/results.csv");
  };
  const std::string here = results({});
  EXPECT_EQ(
      results({"--set", "subsystems.engine.source=lib:" TANDEM_FILE_LIBRARIES "/power_train_library.so"}),
      here);
  EXPECT_EQ(results({"--set", "subsystems.kart.source=spawn:" TANDEM_COMMAND " serve mechanism:" + kart +
                                  "spatial_scalar_spin.toml"}),
            here);
}

TEST(FileLibrary, GoesOnFromACheckpoint) {
  const Scratch folder;
  ASSERT_EQ(half_a_second(folder, {"--output", "here"}).status, 0);
  const std::vector<std::string> there = {
      "--output", "there", "--set", file_library("engine"), "--set", file_library("linkage")};
  auto more = there;
  more.insert(more.end(), {"--checkpoint-every", "0.13"});
  ASSERT_EQ(half_a_second(folder, more).status, 0);
  more = there;
  more.insert(more.end(), {"--resume", "there/checkpoint"});
  const Said said = half_a_second(folder, more);
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(read_text(folder.path() / "there/results.csv"), read_text(folder.path() / "here/results.csv"));
}

TEST(FileLibrary, RefusesAParameterThatTheFileHasNot) {
  const Scratch folder;
  const Said said = half_a_second(
      folder, {"--set", file_library("engine"), "--set", "subsystems.engine.parameters.thrtle=3"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "engine_library.so") && contains(said.err, "'thrtle'")) << said.err;
}

}  // namespace
}  // namespace tandem
