// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What the kart's files must not say, and where the command names it.
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Said;
using test::Scratch;

/// The scene's files with one of them changed.
class ChangedScene {
 public:
  ChangedScene(const std::string& file, const std::string& piece, const std::string& instead) {
    const fs::path scenes = fs::path(TANDEM_SOURCE_DIR) / "scenarios";
    for (const char* name : {"engine", "kart"})
      fs::copy(scenes / name, folder_.path() / name, fs::copy_options::recursive);
    std::string text = test::read_text(folder_.path() / file);
    const auto at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece << " is not in " << file;
    folder_.write(file, text.replace(at, piece.size(), instead));
  }
  /// The command ends with status 2 and says each of these.
  void refuses(const std::vector<std::string>& command, const std::vector<std::string>& words) const {
    const Said said = test::tandem(folder_, command);
    EXPECT_EQ(said.status, 2) << said.err;
    for (const std::string& word : words)
      EXPECT_TRUE(contains(said.err, word)) << word << " not in: " << said.err;
  }

 private:
  Scratch folder_;
};

const std::vector<std::string> validate = {"validate", "kart/kart.toml"};

TEST(KartBadInput, RatiosOfGearsThatDoNotFallAreRefused) {
  ChangedScene("engine/gears.toml", "[2.393, 1.45, 1.0]", "[2.393, 1.0, 1.45]")
      .refuses(validate,
               {"gears.toml:20", "ratio is 1.45 in 'third'", "above 0 and below 1, that of 'second'"});
  ChangedScene("engine/gears.toml", "[2.393, 1.45, 1.0]", "[2.393, 1.45, -1.0]")
      .refuses(validate, {"gears.toml:20", "ratio is -1 in 'third'", "a number above 0"});
}

TEST(KartBadInput, SpeedsOfShiftsOutOfOrderAreRefused) {
  ChangedScene("engine/gears.toml", "y = [4, 6, 13, 15, 18]", "y = [4, 6, 13, 15, 31]")
      .refuses(validate, {"gears.toml:24", "from 'second' to 'third' is 30 at 25",
                          "above 31, the threshold from 'first'"});
  ChangedScene("engine/clutch_gearbox.toml", "up23 = { value = 14.0", "up23 = { value = 7.0")
      .refuses(
          {"validate", "kart/kart.toml", "--set", "subsystems.engine.parameters.gearbox=clutch_gearbox.toml"},
          {"clutch_gearbox.toml:26", "from 'second' to 'third' is 7", "above 11.2"});
}

TEST(KartBadInput, AThrottleBeyondItsPlateEndsTheRun) {
  const Scratch folder;
  for (const char* value : {"-1", "50.5"}) {
    const Said said = test::tandem(folder, {"run", TANDEM_SOURCE_DIR "/scenarios/kart/kart.toml", "--set",
                                            std::string("subsystems.engine.inputs.throttle=") + value});
    EXPECT_EQ(said.status, 1) << said.err;
    EXPECT_TRUE(contains(said.err, "limit 'engine.manifold.throttle'")) << said.err;
    EXPECT_TRUE(contains(said.err, "the plate turns from 0 to 50 deg")) << said.err;
  }
}

TEST(KartBadInput, ANegativeMassIsRefused) {
  ChangedScene("kart/spatial_scalar_spin.toml", "mass = 3\n", "mass = -3\n")
      .refuses(validate, {"spatial_scalar_spin.toml:", "mass is the number -3", "a number above 0"});
}

}  // namespace
}  // namespace tandem
