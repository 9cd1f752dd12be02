// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sentences tell by how many metres or radians an equation of squares or products is off, and its rate.
#include <gtest/gtest.h>

#include <iterator>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

/// A point P drawn at (1, 0, ..) that all coordinates are given of, and a constraint.
struct OffCase {
  const char* name;
  std::string text, positions, velocities, says;
};
void PrintTo(const OffCase& c, std::ostream* out) { *out << c.name; }

const std::string in_plane =
    "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\n"
    "[vectors]\ne = { at = [2, 0], fixed = true }\n[masses]\nm = { point = 'P', mass = 1, free = true }\n";
const std::string in_space =
    "dimension = 3\n[points]\nO = { at = [0, 0, 0], fixed = true }\nP = { at = [1, 0, 0] }\n"
    "[vectors]\ne = { at = [2, 2, 0], fixed = true }\nz = { at = [0, 0, 3], fixed = true }\n"
    "[masses]\nm = { point = 'P', mass = 1, free = true }\n";
const std::string length = "[lengths]\ns = { points = ['O', 'P'] }\n",
                  angle = "[angles]\nt = { from = 'e', to = ['O', 'P'] }\n",
                  about_z = "[angles]\nt = { from = 'e', to = ['O', 'P'], axis = 'z' }\n",
                  fixed_angle = "[fixed_angles]\nf = { edges = ['e', ['O', 'P']] }\n";

const OffCase off_cases[] = {
    {"Length", in_plane + length, "s = 1.5, 'P.x' = 3, 'P.y' = 4", "", "'length s' (m:10) is off by 3.5 m"},
    {"LengthRate", in_plane + length, "s = 5, 'P.x' = 3, 'P.y' = 4", "s = 2, 'P.x' = 5, 'P.y' = 0",
     "'length s' (m:10) is off by 1 m/s"},
    {"Angle", in_plane + angle, "t = 2, 'P.x' = 3, 'P.y' = 0", "", "'angle t' (m:10) is off by 2 rad"},
    {"AngleRate", in_plane + angle, "", "t = 3, 'P.x' = 0, 'P.y' = 1", "'angle t' (m:10) is off by 2 rad/s"},
    {"FixedAngle", in_plane + fixed_angle, "'P.x' = 3, 'P.y' = 3", "",
     "'fixed angle f' (m:10) is off by 0.785398 rad"},
    {"FixedAngleRate", in_plane + fixed_angle, "", "'P.x' = 0, 'P.y' = 3",
     "'fixed angle f' (m:10) is off by 3 rad/s"},
    {"AngleInSpace", in_space + about_z, "t = 0, 'P.x' = 0, 'P.y' = 1, 'P.z' = 7", "",
     "'angle t' (m:11) is off by 0.785398 rad"},
    {"FixedAngleInSpace", in_space + fixed_angle, "'P.x' = 3, 'P.y' = 3, 'P.z' = 0", "",
     "'fixed angle f' (m:11) is off by 0.785398 rad"},
    {"FixedAngleInSpaceRate", in_space + fixed_angle, "", "'P.x' = 0, 'P.y' = 3, 'P.z' = 0",
     "'fixed angle f' (m:11) is off by 3 rad/s"},
    {"DriveOfAVector",
     "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\n[vectors]\nu = { at = [1, 0] }\n"
     "[bodies.b]\npoints = ['O']\nvectors = ['u']\nmass = 1\ncentre = [0, 0]\ninertia = 1\n"
     "[inputs]\nx = { unit = '1', polynomial = [0.25] }\n[drives]\nd = { coordinate = 'u.x', motion = 'x' "
     "}\n",
     "'u.x' = 1, 'u.y' = 0", "", "'drive d' (m:15) is off by 0.75"}};

class OffBy : public testing::TestWithParam<OffCase> {};

TEST_P(OffBy, IsToldInMetresOrRadians) {
  const OffCase& c = GetParam();
  const std::string text =
      c.text + "[initial]\npositions = { " + c.positions + " }\nvelocities = { " + c.velocities + " }\n";
  Mechanism m(read_mechanism("m", text));
  EXPECT_TRUE(
      test::refuses(ErrorCode::invalid_argument, {"constraint " + c.says}, [&] { initial_state(m, 0.0); }));
}

TEST(Off, AVectorsDriveIsAPureNumber) {
  const Mechanism m(read_mechanism("m", std::end(off_cases)[-1].text));
  EXPECT_EQ(m.structure().unit_of(m.drive_equation(0)), "");
  EXPECT_EQ(m.structure().unit_of(m.drive_equation(0), true), " 1/s");
}

INSTANTIATE_TEST_SUITE_P(, OffBy, testing::ValuesIn(off_cases),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace tandem::mbs
