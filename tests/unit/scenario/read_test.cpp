// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {
namespace {

using test::refuses;
using test::Scratch;

constexpr const char* whole = R"(name = "scene"
description = "what it is"
[parameters]
k = 2
flag = true
[subsystems.slow]
source = "builtin:s"
parameters = { k = 3.5, word = "text" }
inputs = { u = 1, v = [4, 5] }
[subsystems.fast]
source = "builtin:f"
[[connections]]
from = "slow.y"
to = "fast.u"
reconstruction = "least_squares2_4"
gain = 2
offset = -1
add = true
convert = true
delay = true
[coordination]
schedule = "parallel"
order = ["fast", "slow"]
communication_step = 0.25
coupling = "signals"
start = "cold"
[span]
start = -1
stop = 2
[record]
clock = "slow"
ports = ["fast.y"]
[reference]
file = "other.csv"
tolerance = 0.1
[judge]
quantity = "fast.y"
tolerance = 0.01
)";

TEST(Read, TakesEveryKey) {
  const Scratch folder;
  const Scenario s = read(folder.write("scene.toml", whole));
  EXPECT_EQ(s.name, "scene");
  EXPECT_EQ(s.description, "what it is");
  EXPECT_EQ(s.coordination.schedule, Schedule::Kind::parallel);
  EXPECT_EQ(s.coordination.order, (std::vector<std::string>{"fast", "slow"}));
  EXPECT_EQ(s.coordination.communication_step, 0.25);
  EXPECT_EQ(s.coordination.start, StartKind::cold);
  EXPECT_EQ(s.start, -1.0);
  EXPECT_EQ(s.stop, 2.0);
  EXPECT_EQ(s.recording.clock, "slow");
  EXPECT_EQ(s.recording.ports, std::vector<std::string>{"fast.y"});
  EXPECT_EQ(s.reference->file, folder.path() / "other.csv");
  EXPECT_EQ(s.reference->tolerance, 0.1);
  EXPECT_EQ(s.judge->quantity, "fast.y");
}

TEST(Read, SubsystemsStandInTheOrderOfTheFile) {
  const Scratch folder;
  const Scenario s = read(folder.write("scene.toml", whole));
  ASSERT_EQ(s.subsystems.size(), 2U);
  EXPECT_EQ(s.subsystems[0].name, "slow");
  EXPECT_EQ(s.subsystems[0].place.line, 6);
}

TEST(Read, ASubsystemsParametersReplaceThoseOfAll) {
  const Scratch folder;
  const auto parameters = read(folder.write("scene.toml", whole)).subsystems[0].parameters;
  ASSERT_EQ(parameters.size(), 3U);
  EXPECT_EQ(parameters[0].name, "flag");
  EXPECT_EQ(std::get<bool>(parameters[0].value), true);
  EXPECT_EQ(std::get<double>(parameters[1].value), 3.5);
  EXPECT_EQ(parameters[1].place.line, 8);
  EXPECT_EQ(std::get<std::string>(parameters[2].value), "text");
}

TEST(Read, StartValuesOfAnArrayAreItsElements) {
  const Scratch folder;
  const auto inputs = read(folder.write("scene.toml", whole)).subsystems[0].inputs;
  ASSERT_EQ(inputs.size(), 3U);
  EXPECT_EQ(inputs[0].port, "u");
  EXPECT_EQ(inputs[2].port, "v[1]");
  EXPECT_EQ(inputs[2].at(0.0), 5.0);
}

TEST(Read, DataOfAnInputStandInAFileOrInTheScenario) {
  const Scratch folder;
  folder.write("d.csv", "time,F\n0,1\n2,5\n");
  const auto inputs_of = [&](const std::string& inputs) {
    return read(folder.write("s.toml", "[subsystems.a]\nsource = 'lib:a.so'\n[subsystems.a.inputs]\n" +
                                           inputs + "\n[span]\nstop = 1\n"))
        .subsystems[0]
        .inputs;
  };
  EXPECT_EQ(inputs_of("u = { file = 'd.csv', column = 'F' }")[0].at(0.5), 2.0);
  EXPECT_EQ(inputs_of("u = { times = [0, 1], values = [1, 3], interpolation = 'hold' }")[0].at(0.5), 1.0);
  EXPECT_EQ(inputs_of("'u[1]' = { times = [0, 1], values = [1, 3], beyond = 'hold' }")[0].at(2.0), 3.0);
  const auto refused = [&](const std::string& inputs, const std::string& sentence) {
    return test::refuses(ErrorCode::invalid_argument, {"s.toml:4", sentence}, [&] { inputs_of(inputs); });
  };
  EXPECT_TRUE(refused("u = { file = 'd.csv', column = 'G' }", "column 'G' is not there"));
  EXPECT_TRUE(refused("u = { file = 'd.csv' }", "subsystems.a.inputs.u.column is missing"));
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"s.toml:4", "e.csv' is not there"},
                            [&] { inputs_of("u = { file = 'e.csv', column = 'F' }"); }));
  EXPECT_TRUE(refused("u = { column = 'F' }", "column has no meaning: there is no file"));
  EXPECT_TRUE(refused("u = {}", "subsystems.a.inputs.u.file is missing"));
  EXPECT_TRUE(refused("u = { times = [0, 1] }", "subsystems.a.inputs.u.values is missing"));
  EXPECT_TRUE(
      refused("u = { times = [0, 1], values = [1] }", "subsystems.a.inputs.u has 2 times and 1 values"));
  EXPECT_TRUE(refused("u = { times = [0, 1], values = [1, 2], interpolation = 'cubic' }",
                      "allowed is linear, hold or spline"));
  EXPECT_TRUE(
      refused("u = { times = [0, 1], values = [1, 2], file = 'd.csv' }", "times is given beside file"));
  EXPECT_TRUE(refused("u = { times = [0, 1], values = [1, 2], unit = 'N' }",
                      "unknown key of [subsystems.a.inputs.u] 'unit'"));
  EXPECT_TRUE(refused("u = 'd.csv'", "allowed is a number"));
}

TEST(Read, AConnectionHasAllItsKeys) {
  const Scratch folder;
  const Connection c = read(folder.write("scene.toml", whole)).connections.at(0).connection;
  EXPECT_EQ(c.from, "slow.y");
  EXPECT_EQ(c.to, "fast.u");
  EXPECT_EQ(c.how.value().name(), "least_squares2_4");
  EXPECT_EQ(c.gain, 2.0);
  EXPECT_EQ(c.offset, -1.0);
  EXPECT_TRUE(c.add);
  EXPECT_TRUE(c.convert);
  EXPECT_EQ(c.lag, Lag::delay);
}

TEST(Read, ASubsystemMayBeToldWhetherToLand) {
  const Scratch folder;
  const auto file = folder.write("scene.toml", whole);
  EXPECT_TRUE(read(file).coordination.landing.empty());
  EXPECT_EQ(read(file, {"subsystems.fast.land=never"}).coordination.landing.at("fast"), Landing::never);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"subsystems.fast.land is 'sometimes'", "automatic, always or never"},
                      [&] { read(file, {"subsystems.fast.land=sometimes"}); }));
}

TEST(Read, OverridesAreKeptAndStandInTheDocument) {
  const Scratch folder;
  const Scenario s = read(folder.write("scene.toml", whole), {"span.stop=7", "record.clock=own"});
  EXPECT_EQ(s.stop, 7.0);
  EXPECT_TRUE(s.recording.own);
  EXPECT_EQ(s.overrides.size(), 2U);
  EXPECT_EQ(nlohmann::json::parse(s.values)["span"]["stop"], 7);
  EXPECT_EQ(s.place("span.stop").set_by, "--set span.stop=7");
  EXPECT_EQ(s.place("span.start").line, 28);
}

TEST(Read, KnowsThePlaceThatAnErrorIsAbout) {
  const Scratch folder;
  const Scenario s = read(folder.write("scene.toml", whole));
  EXPECT_EQ(s.place_named_in("input fast.u of something").line, 12);
  EXPECT_EQ(s.place_named_in("input fast.u is reconstructed by least_squares2_4").line, 15);
  EXPECT_EQ(s.place_named_in("subsystem 'fast' is not well").line, 10);
  EXPECT_EQ(s.place_named_in("the repeated start can't be").line, 26);
  EXPECT_EQ(s.place_named_in("nothing of it").line, 0);
  EXPECT_EQ(s.subsystems[0].place_named_in("k is 3.5, flag is true").line, 8);
}

TEST(Read, RefusesAWholeNumberThatADoubleCannotHold) {
  const Scratch folder;
  const auto file = folder.write("scene.toml", whole);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"parameters.k", "9007199254740993"},
                      [&] { read(file, {"parameters.k=9007199254740993"}); }));
}

}  // namespace
}  // namespace tandem::scenario
