// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs of a mechanism: their units, and data from files.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

/// Ten lines.
const std::string turned_rod =
    "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\n[rods]\n"
    "rod = { points = ['O', 'P'], mass = 1 }\n[vectors]\ne = { at = [1, 0], fixed = true }\n[angles]\n"
    "t = { from = 'e', to = ['O', 'P'] }\n";

testing::AssertionResult inputs_refused(const std::string& text, const std::vector<std::string>& says) {
  return refuses(ErrorCode::invalid_argument, says, [&] { read_mechanism("m", text); });
}

/// As the coordinator spells them.
TEST(ReadInputs, RefusesAUnitThatTheirUseHasNot) {
  const auto input = [](const std::string& unit, const std::string& use) {
    return turned_rod + "[inputs]\nF = { unit = '" + unit + "', value = 0 }\n" + use;
  };
  const std::string push = "[forces]\nf = { point = 'P', direction = [0, 1], magnitude = 'F' }\n",
                    torque = "[forces]\nf = { coordinate = 't', magnitude = 'F' }\n",
                    motor = "[drives]\nf = { coordinate = 't', motion = 'F' }\n",
                    slide = "[drives]\nf = { coordinate = 'P.x', motion = 'F' }\n";
  EXPECT_TRUE(
      inputs_refused(input("m", push), {"m:14: forces.f.magnitude is 'F' in m; allowed is an input in N"}));
  EXPECT_TRUE(inputs_refused(input("N", torque), {"m:14", "'F' in N; allowed is an input in N m"}));
  EXPECT_TRUE(inputs_refused(input("deg", motor),
                             {"m:14: drives.f.motion is 'F' in deg; allowed is an input in rad"}));
  EXPECT_TRUE(inputs_refused(input("rad", slide), {"m:14", "'F' in rad; allowed is an input in m"}));
  EXPECT_TRUE(inputs_refused(input("", push), {"m:12: inputs.F.unit is empty"}));
  EXPECT_NO_THROW(read_mechanism("m", input("N", push)));
  EXPECT_NO_THROW(read_mechanism("m", input("N m", torque)));
  EXPECT_NO_THROW(read_mechanism("m", input("rad", motor)));
  EXPECT_NO_THROW(read_mechanism("m", input("m", slide)));
  const std::string stiffness =
      "[forces]\nf = { point = 'P', direction = [0, 1], magnitude = 'F', gain = 30 }\n";
  EXPECT_NO_THROW(read_mechanism("m", input("m", stiffness)));
}

/// Lines of the mechanism, and of the file that it names.
TEST(ReadInputs, RefusesDataThatADriveCanNotFollow) {
  const test::Scratch folder;
  folder.write("jump.csv", "time,F\n0,0\n0.1,1\n0.1,2\n1,3\n");
  folder.write("wrong.csv", "time,F\n0,0\n0.1,nan\n");
  folder.write("empty.csv", "time,F\n0,0\n0.1,\n1,0\n");
  folder.write("good.csv", "time,F\n0,0\n0.1,1\n1,3\n");
  const auto read = [&](const std::string& rest, bool drive = true) {
    const auto file =
        folder.write("p.toml", turned_rod + "[inputs]\nF = { unit = '" + (drive ? "rad" : "N m") +
                                   "', column = 'F', " + rest + " }\n" +
                                   (drive ? "[drives]\nd = { coordinate = 't', motion = 'F' }\n"
                                          : "[forces]\nd = { coordinate = 't', magnitude = 'F' }\n"));
    return [=] { read_mechanism(file); };
  };
  const auto says = [&](const std::vector<std::string>& words, const auto& action) {
    return refuses(ErrorCode::invalid_argument, words, action);
  };
  EXPECT_TRUE(says({"p.toml:14: drives.d.motion is 'F'", "no acceleration", "interpolation = \"spline\""},
                   read("file = 'good.csv'")));
  EXPECT_TRUE(says({"p.toml:12: ", "jump.csv has the time 0.1 s twice, which is a jump"},
                   read("file = 'jump.csv', interpolation = 'spline'")));
  EXPECT_TRUE(
      says({"p.toml:12: ", "wrong.csv:3: column 2 holds something else"}, read("file = 'wrong.csv'")));
  EXPECT_TRUE(
      says({"p.toml:12: ", "empty.csv:3: column 'F' is empty; allowed is a finite number in each row"},
           read("file = 'empty.csv'")));
  EXPECT_NO_THROW(read("file = 'good.csv', interpolation = 'spline'")());
  EXPECT_NO_THROW(read("file = 'jump.csv'", false)());
}

}  // namespace
}  // namespace tandem::mbs
