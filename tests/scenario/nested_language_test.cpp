// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What may be set of a scenario that is one subsystem, and what it can't be of.
#include <gtest/gtest.h>

#include "command.hpp"
#include "nested_open.hpp"
#include "nested_scene.hpp"
#include "refusal.hpp"
#include "tandem/scenario/nested.hpp"

namespace tandem::test {
namespace {

TEST(NestedLanguage, TakesConstantsAndParametersOfMembers) {
  const Scratch folder;
  write_three_masses(folder);
  const std::string file = place(folder, "pair.toml");
  const auto end = [](Subsystem& one) { return alone(one, 1.0).rows(0).back(); };
  const auto set = [&](const std::string& key) { return end(*nested(file, {key})); };
  EXPECT_EQ(end(*nested(file + "?m3=3&three.x0=1")),
            end(*nested(file, {"constants.m3=3", "subsystems.three.parameters.x0=1"})));
  EXPECT_EQ(end(*nested(file + "?two.x0=0.5")), set("subsystems.two.parameters.x0=0.5"));
  EXPECT_NE(end(*nested(file + "?two.x0=0.5")), end(*nested(file)));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'three.m'", "three.x0"}, [&] { nested(file + "?three.m=2"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"h", "number"}, [&] { nested(file + "?h=fast"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"step", "above 0"}, [&] { nested(file + "?step=0"); }));
}

void expect_refused(const std::string& text, std::vector<std::string> words) {
  const Scratch folder;
  write_plant(folder);
  words.push_back("s.toml:");
  const std::string file = folder.write("s.toml", text).string();
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, words, [&] { nested(file); })) << text;
}

TEST(NestedLanguage, RefusesWhatItCanNotBeOf) {
  const std::string span = "[span]\nstop = 1\n";
  expect_refused("[subsystems.a]\nsource = 'tcp://localhost:9'\n" + span,
                 {"'a' is tcp://localhost:9", "diagram:FILE, mechanism:FILE, scenario:FILE"});
  expect_refused("[subsystems.a]\nsource = 'lib:./x.so'\n" + span, {"'a' is lib:./x.so", "allowed are"});
  expect_refused("[subsystems.a]\ncommand = ['true']\n" + span, {"'a' is command", "allowed are"});
  expect_refused("[subsystems.a]\nsource = 'scenario:s.toml'\n" + span, {"'a' is scenario", "in itself"});
  expect_refused(
      "[subsystems.a]\nsource = 'diagram:damper.toml'\ninputs = { v = 0 }\n[record]\nports = ['a.w']\n" +
          span,
      {"a.w", "a.u"});
  expect_refused("[coordination]\nscheme = 'auto'\n[subsystems.a]\nsource = 'scenario:drive.toml'\n" + span,
                 {"coordination.scheme is auto"});
}

/// Each level has so many of the one below it.
void write_levels(const Scratch& folder, int levels, int many) {
  write_plant(folder);
  folder.write("level0.toml", read_text(folder.path() / "drive.toml"));
  for (int level = 1; level <= levels; ++level) {
    std::string text = "[span]\nstop = 1\n";
    for (int k = 0; k < many; ++k)
      text += "[subsystems.s" + std::to_string(k) + "]\nsource = 'scenario:level" +
              std::to_string(level - 1) + ".toml'\n";
    folder.write("level" + std::to_string(level) + ".toml", text);
  }
}

TEST(NestedLanguage, RefusesMoreThanAMachineHolds) {
  const Scratch wide, deep;
  write_levels(wide, 3, 100), write_levels(deep, 4, 1);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"level2.toml:", "more than 10000 subsystems"},
                      [&] { nested(place(wide, "level3.toml")); }));
  EXPECT_NO_THROW(nested(place(deep, "level3.toml")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"level4.toml:4", "'s0'", "5 deep", "allowed are 4"},
                      [&] { nested(place(deep, "level4.toml")); }));
}

TEST(NestedLanguage, RefusesNamesThatWouldSetTwoThings) {
  const Scratch folder;
  write_plant(folder);
  folder.write("s.toml",
               "[constants]\n\"plant.m\" = 0.5\n[subsystems.plant]\nsource = 'diagram:plant.toml'\n"
               "parameters.step = \"$plant.m\"\ninputs = { F = 0, d = 0 }\n[span]\nstop = 1\n");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"s.toml", "'plant.m'", "a name of its own"},
                      [&] { nested(place(folder, "s.toml")); }));
}

/// Constants that nothing uses, and names that no key can have, are not among them.
TEST(NestedLanguage, OffersWhatCanBeSetAlone) {
  const Scratch folder;
  write_three_masses(folder);
  folder.write(
      "s.toml",
      "[constants]\nunused = 1\nstep = 2\n'a\"b' = 1\nm = 2\n[subsystems.q]\nsource = 'scenario:pair.toml'\n"
      "parameters ={ two = { m = 3 }, h = '$m', step = '$step' }\n[span]\nstop = 400\n");
  Parameters given;
  std::string names;
  for (const auto& p : scenario::parameters_of("scenario:" + place(folder, "s.toml"), {}, {}, given)) {
    names += p.name + "; ";
    EXPECT_NO_THROW(nested(place(folder, "s.toml") + "?" + p.name + "=0.25")) << p.name;
  }
  EXPECT_EQ(names, "m; q.m3; q.two.m; q.two.k; q.two.s; q.two.x0; q.three.k; q.three.s; q.three.x0; ");
}

TEST(NestedLanguage, TellsWhatMayBeSetOfIt) {
  const Scratch folder;
  write_three_masses(folder);
  const Said said = tandem(folder, {"info", "scenario:pair.toml?m3=2"});
  for (const char* line : {"  parameter h = 0.01\n", "  parameter m3 = 2\n", "  parameter two.m = 2 kg\n"})
    EXPECT_TRUE(contains(said.out, line)) << said.out;
  EXPECT_FALSE(contains(said.out, "three.m "));
  EXPECT_TRUE(contains(tandem(folder, {"info", "diagram:mass.toml?m=4"}).out, "  parameter m = 4 kg\n"));
}

}  // namespace
}  // namespace tandem::test
