// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Parameters of mechanisms in files.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

const std::string with_parameters =
    "dimension = 2\n[parameters]\nm = { value = 2, unit = 'kg' }\nL = { value = 3, unit = 'm' }\n"
    "k = { value = 8, unit = 'N/m' }\nend = { value = 'P' }\npush = { value = 5, unit = 'N' }\n[points]\n"
    "O = { at = [0, 0], fixed = true }\nP = { at = ['$L', '$(L/2)'] }\n[rods]\nr = { points = ['O', '$end'], "
    "mass = '$m' }\n"
    "[springs]\ns = { points = ['O', 'P'], stiffness = ['$k', 0, '$(k/4)'], free = '$(2*L)' }\n[forces]\n"
    "f = { point = '$end', direction = [1, 0], magnitude = '$push', gain = '$(1/m)' }\n"
    "[outputs]\nx = { position = 'P.x' }\nrise = { elevation = ['O', '$end'] }\n";

TEST(MechanismParameters, StandWhereNumbersAndWordsDo) {
  const Description d = read_mechanism("d", with_parameters);
  ASSERT_EQ(d.parameters.size(), 5U);
  EXPECT_EQ(d.entities[1].at, Eigen::Vector3d(3.0, 1.5, 0.0));
  EXPECT_EQ(d.springs[0].stiffness, (std::vector<double>{8.0, 0.0, 2.0}));
  EXPECT_EQ(d.springs[0].free, 6.0);
  EXPECT_EQ(d.inputs[0].value, 5.0);
  EXPECT_EQ(d.forces[0].gain, 0.5);
  EXPECT_EQ(d.forces[0].index, 1);
  EXPECT_EQ(d.outputs[1].edge.to, 1);
}

TEST(MechanismParameters, AreGiven) {
  const Description d = read_mechanism("d", with_parameters, {}, {{"L", 4.0}, {"m", 0.5}});
  EXPECT_EQ(d.entities[1].at, Eigen::Vector3d(4.0, 2.0, 0.0));
  EXPECT_EQ(d.forces[0].gain, 2.0);
  test::refuses(ErrorCode::invalid_argument, {"d:", "unknown parameter 'M'", "did you mean 'm'"}, [] {
    read_mechanism("d", with_parameters, {}, {{"M", 1.0}});
  });
}

TEST(MechanismParameters, ThatAreNotThereAreRefusedInTheirPlace) {
  const auto with = [](const std::string& rod) {
    return "dimension = 2\n[parameters]\nm = { value = 2, unit = 'kg' }\nw = { value = 'x' }\n[points]\n"
           "O = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\n[rods]\n" +
           rod;
  };
  const auto refuses = [&](const std::string& mass, const std::vector<std::string>& says) {
    test::refuses(ErrorCode::invalid_argument, says,
                  [&] { read_mechanism("d", with("r = { points = ['O', 'P'], mass = " + mass + " }\n")); });
  };
  refuses("'$n'", {"d:9", "rods.r.mass", "unknown parameter 'n'"});
  refuses("'$w'", {"d:9", "rods.r.mass", "the word 'x'", "a number"});
  refuses("'$(m - 2)'", {"d:9", "rods.r.mass", "'$(m - 2)', 0", "a number above 0"});
  refuses("'$(m - 2'", {"d:9", "rods.r.mass", "in brackets"});
  refuses("'$(m/0)'", {"d:9", "rods.r.mass", "'m/0' is inf", "m = 2"});
  refuses("'m'", {"d:9", "rods.r.mass is the text 'm'"});
}

}  // namespace
}  // namespace tandem::mbs
