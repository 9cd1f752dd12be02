// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a ladder says of its rungs: read from a file, and judged by tables that are written here.
#include "ladder/ladder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::scenario {
namespace {

using test::refuses;
using test::Scratch;

constexpr const char* one_subsystem = R"([subsystems.a]
source = "builtin:s"
[span]
stop = 2
)";

Scenario with_ladder(const Scratch& folder, const std::string& table) {
  return read(folder.write("scene.toml", one_subsystem + table));
}

TEST(Ladder, IsReadWithWhatAllRungsShareAndItsOwnFiles) {
  const Scratch folder;
  const Scenario scene = with_ladder(folder, R"([ladder]
set = ["span.stop=1"]
[[ladder.judged]]
quantity = "a.y"
tolerance = 0.5
unit = "deg"
[[ladder.rungs]]
name = "simple"
set = ["subsystems.a.source=builtin:t"]
outputs = { "a.y" = "a.z" }
[[ladder.rungs]]
name = "rich"
file = "rich.toml"
)");
  const LadderEntry& ladder = *scene.ladder;
  EXPECT_EQ(ladder.quantities[0].unit, "deg");
  ASSERT_EQ(ladder.rungs.size(), 2U);
  EXPECT_EQ(ladder.rungs[0].overrides,
            (std::vector<std::string>{"span.stop=1", "subsystems.a.source=builtin:t"}));
  EXPECT_EQ(ladder.rungs[0].outputs.at("a.y"), "a.z");
  EXPECT_EQ(ladder.rungs[1].file, folder.path() / "rich.toml");
  EXPECT_TRUE(ladder.rungs[1].overrides.empty());  // another file has other keys
}

TEST(Ladder, IsJudgedByWhatTheSceneIsJudgedBy) {
  const Scratch folder;
  const Scenario scene = with_ladder(folder, R"([judge]
quantity = "a.y"
tolerance = 0.25
[ladder]
[[ladder.rungs]]
name = "simple"
[[ladder.rungs]]
name = "rich"
)");
  EXPECT_EQ(scene.ladder->quantities[0].quantity, "a.y");
  EXPECT_EQ(scene.ladder->quantities[0].tolerance, 0.25);
}

TEST(Ladder, RefusesWhatItCannotMean) {
  const Scratch folder;
  const std::string judged = "[[ladder.judged]]\nquantity = \"a.y\"\ntolerance = 1\n",
                    rung = "[[ladder.rungs]]\nname = \"one\"\n";
  struct Case {
    std::string table;
    std::vector<std::string> words;
  };
  for (const Case& c : {Case{rung + rung, {"ladder.judged"}},
                        {judged + rung, {"ladder.rungs", "two or more"}},
                        {judged + rung + rung, {"'one' again"}},
                        {judged + "[[ladder.rungs]]\nname = \"a/b\"\n", {"'a/b'"}},
                        {judged + rung + "outputs = { \"a.x\" = \"a.z\" }\n", {"a.x", "judged quantity"}},
                        {judged + rung + "speed = 1\n", {"speed"}}})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, c.words, [&] { with_ladder(folder, c.table); }))
        << c.table;
}

/// a.y over three instants.
RungRun run_of(const std::string& name, std::vector<double> y) {
  return {name, text::TimeTable{name, {0.0, 1.0, 2.0}, {"a.y"}, {std::move(y)}}, "", 1.0};
}

const LadderQuantity in_degrees{"a.y", 0.5, "deg", {"scene.toml"}}, in_parts{"a.y", 0.05, "", {"scene.toml"}};

/// Off the richest, whose largest is 10, by 3, 0.3 and 0.2.
std::vector<RungRun> four_rungs() {
  return {run_of("point", {0, 7, 1}), run_of("plane", {0, 9.7, 1}), run_of("space", {0, 9.8, 1}),
          run_of("richest", {0, 10, 1})};
}

TEST(Ladder, FindsTheSimplestThatTheNextRicherDoesNotImprove) {
  const auto column = ladder_column(four_rungs(), in_parts, 1.0);
  EXPECT_NEAR(column.from_richest[0], 0.3, 1e-12);
  EXPECT_NEAR(column.to_next[1], 0.01, 1e-12);
  const LadderVerdict verdict = ladder_verdict({column});
  EXPECT_EQ(verdict.simplest, 1U);
  EXPECT_FALSE(verdict.next_changes);
  EXPECT_TRUE(verdict.useless.empty());
  EXPECT_TRUE(verdict.worse.empty());
  const std::string text = ladder_text(four_rungs(), {column});
  for (const char* words :
       {"simplest within the tolerances: plane", "next simpler, point, is not: a.y by 30 %",
        "next richer, space, changes nothing that matters"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

/// 0.3 becomes 0.8 of an allowed 0.5.
TEST(Ladder, ChangesItsVerdictWithALevel) {
  auto runs = four_rungs();
  runs[1].table->columns[0][1] = 9.2;
  const LadderVerdict verdict = ladder_verdict({ladder_column(runs, in_parts, 1.0)});
  EXPECT_EQ(verdict.simplest, 2U);
  runs[1] = run_of("plane", {0, 4, 1});  // farther off than the point
  EXPECT_EQ(ladder_verdict({ladder_column(runs, in_parts, 1.0)}).useless, std::vector<std::size_t>{1});
  EXPECT_NE(ladder_text(runs, {ladder_column(runs, in_parts, 1.0)}).find("plane is of no use"),
            std::string::npos);
  runs[0] = run_of("point", {0, 9.9, 1});
  EXPECT_EQ(ladder_verdict({ladder_column(runs, in_parts, 1.0)}).worse, std::vector<std::size_t>{1});
}

/// Of two quantities the stricter one decides; each by itself is told too.
TEST(Ladder, TellsTheSimplestForEachQuantityToo) {
  const auto loose = ladder_column(four_rungs(), {"a.y", 0.5, "", {"scene.toml"}}, 1.0),
             strict = ladder_column(four_rungs(), {"a.y", 0.025, "", {"scene.toml"}}, 1.0);
  EXPECT_EQ(ladder_verdict({loose, strict}).simplest, 2U);
  const std::string text = ladder_text(four_rungs(), {loose, strict});
  EXPECT_NE(text.find("simplest for a.y alone: point\nsimplest for a.y alone: space\n"), std::string::npos)
      << text;
}

TEST(Ladder, ConvertsTheToleranceIntoItsUnit) {
  const double degrees = 180.0 / std::acos(-1.0);
  const auto column = ladder_column(four_rungs(), in_degrees, degrees);
  EXPECT_NEAR(column.from_richest[2], 0.2 * degrees, 1e-12);
  EXPECT_EQ(ladder_verdict({column}).simplest, 3U);
  EXPECT_NE(ladder_text(four_rungs(), {column}).find("only the richest"), std::string::npos);
}

/// Differences of 3, 0.3 and 0.2 in the middle of three rows, of a richest whose rms is sqrt(101 / 3).
TEST(Ladder, MeasuresTheRmsWhereItIsJudgedByIt) {
  LadderQuantity judged = in_parts;
  judged.measure.norm = Norm::rms;
  const auto column = ladder_column(four_rungs(), judged, 1.0);
  EXPECT_NEAR(column.from_richest[0], 3.0 / std::sqrt(101.0), 1e-12);
  EXPECT_NEAR(column.to_next[1], 0.1 / std::sqrt(101.0), 1e-12);
  EXPECT_NE(ladder_text(four_rungs(), {column}).find("allowed: a.y 5 % in rms"), std::string::npos);
}

TEST(Ladder, CountsWhatFailsOrIsAbsentAsBeyond) {
  auto runs = four_rungs();
  runs[1].table.reset(), runs[1].failure = "lost at 1 s";
  runs[0].table->names = {"a.x"};
  const auto column = ladder_column(runs, in_parts, 1.0);
  EXPECT_TRUE(std::isnan(column.from_richest[0]) && std::isnan(column.from_richest[1]));
  EXPECT_EQ(ladder_verdict({column}).simplest, 2U);
  const std::string rows = ladder_rows(runs, {column});
  EXPECT_NE(rows.find("\"point\",a.y,1,max,,,0.05,0,1,absent\n\"plane\",a.y,1,max,,,0.05,0,1,failed\n"),
            std::string::npos)
      << rows;
  runs[3].table.reset(), runs[3].failure = "lost too";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"scene.toml", "richest", "lost too"},
                      [&] { ladder_column(runs, in_parts, 1.0); }));
}

}  // namespace
}  // namespace tandem::scenario
