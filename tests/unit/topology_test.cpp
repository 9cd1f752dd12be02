// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/topology.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "connection.hpp"
#include "refusal.hpp"

namespace tandem {
namespace {

using test::added;
using test::connection;
using test::refuses;

const SubsystemInfo motor{"motor", {{"torque", "N m"}}, {{"speed", "rpm"}, {"angle", "rad", 1, 1}}, {}, {}};
const SubsystemInfo shaft{"shaft",
                          {{"speed", "rad/s"}, {"angle", "rad"}, {"loads", "N", 3}},
                          {{"torque", "N m"}, {"forces", "N", 3}},
                          {},
                          {}};

class TopologyTest : public testing::Test {
 protected:
  TopologyTest() {
    topology.add("motor", motor);
    topology.add("shaft", shaft);
  }
  testing::AssertionResult refuses_connection(const Connection& c, const std::vector<std::string>& texts) {
    return refuses(ErrorCode::invalid_argument, texts, [&] { topology.connect(c); });
  }
  Topology topology;
};

/// As of a connection to what is not known here.
TEST_F(TopologyTest, HalfAConnectionIsLookedForAndCountsAsOne) {
  const auto half = [&](const char* port, bool output) {
    return [this, port, output] { topology.connect_half(port, output); };
  };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'shaft'", "input 'sped'", "did you mean 'speed'"},
                      half("shaft.sped", false)));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'motor'", "output 'torque'"}, half("motor.torque", true)));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"no element 3", "0 to 2"}, half("shaft.loads[3]", false)));
  half("shaft.forces", true)();
  for (const char* input : {"motor.torque", "shaft.speed", "shaft.angle", "shaft.loads[0]", "shaft.loads[2]"})
    half(input, false)();
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"shaft.loads[1] is not connected"}, [&] { topology.check(); }));
  half("shaft.loads", false)();
  EXPECT_NO_THROW(topology.check());
  EXPECT_TRUE(topology.lines().empty());
}

TEST_F(TopologyTest, UnknownInstancesAndPortsAreNamedWithTheNearestKnownOne) {
  EXPECT_TRUE(refuses_connection(connection("motr.angle", "shaft.angle"),
                                 {"'motr'", "did you mean 'motor'", "motor, shaft"}));
  EXPECT_TRUE(refuses_connection(connection("motor.angel", "shaft.angle"),
                                 {"output 'angel'", "did you mean 'angle'", "'motor'"}));
  EXPECT_TRUE(refuses_connection(connection("motor.angle", "shaft.speeed"),
                                 {"input 'speeed'", "did you mean 'speed'", "'shaft'"}));
  EXPECT_TRUE(
      refuses_connection(connection("motor.torque", "shaft.angle"), {"output 'torque'", "speed, angle"}))
      << "an input, not an output";
  EXPECT_TRUE(refuses_connection(connection("angle", "shaft.angle"), {"'angle'", "instance.port"}));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'torqe'", "'torque'"},
                      [&] { topology.set_start("motor.torqe", 1.0); }));
}

TEST_F(TopologyTest, ElementsOfArraysAreCheckedAgainstTheirSize) {
  for (const char* index : {"[", "[]", "[x]", "[-1]", "[1", "[1]x", "[1.5]", "[ 1]", "[99999999999]"})
    EXPECT_TRUE(refuses_connection(connection("shaft.forces" + std::string(index), "shaft.loads[0]"),
                                   {"shaft.forces" + std::string(index)}));
  EXPECT_TRUE(refuses_connection(connection("shaft.forces[3]", "shaft.loads[0]"),
                                 {"shaft.forces[3]", "no element 3", "0 to 2"}));
  EXPECT_TRUE(refuses_connection(connection("motor.angle[1]", "shaft.angle"), {"no element 1", "0 to 0"}));
}

TEST_F(TopologyTest, SizesHaveToAgree) {
  EXPECT_TRUE(refuses_connection(connection("shaft.forces", "shaft.loads[0]"),
                                 {"shaft.forces", "shaft.loads[0]", "3 scalars to 1"}));
  EXPECT_TRUE(refuses_connection(connection("motor.angle", "shaft.loads"), {"1 scalars to 3"}));
}

TEST_F(TopologyTest, UnitsHaveToAgreeOrBeConverted) {
  EXPECT_TRUE(
      refuses_connection(connection("motor.speed", "shaft.speed"), {"'rpm' to 'rad/s'", "convert = true"}));
  EXPECT_TRUE(refuses_connection(connection("motor.angle", "shaft.loads[0]"),
                                 {"'rad' to 'N'", "can't be converted"}));
  Connection c = connection("motor.angle", "shaft.loads[0]");
  c.convert = true;
  EXPECT_TRUE(refuses_connection(c, {"'rad' to 'N'", "can't be converted"}));
}

TEST_F(TopologyTest, AUnitThatIsNotSaidFitsEveryOther) {
  const SubsystemInfo silent{"silent", {{"u", ""}}, {{"y", ""}}, {}, {}};
  topology.add("silent", silent);
  topology.connect(connection("silent.y", "shaft.speed"));
  topology.connect(connection("motor.speed", "silent.u"));
  EXPECT_EQ(topology.lines().back().gain, 1.0);
}

TEST_F(TopologyTest, GainAndOffsetApplyAfterTheConversionOfUnits) {
  Connection c = connection("motor.speed", "shaft.speed");
  c.convert = true;
  c.gain = 2.0;
  c.offset = 5.0;
  topology.connect(c);
  const Line& line = topology.lines().at(0);
  EXPECT_NEAR(line.gain, 2.0 * std::acos(-1.0) / 30.0, 1e-16);
  EXPECT_EQ(line.offset, 5.0);
}

TEST(Topology, AUnitWithAnotherZeroShiftsBeforeTheGain) {
  const SubsystemInfo info{"t", {{"k", "K"}}, {{"c", "degC"}}, {}, {}};
  Topology topology;
  topology.add("a", info);
  Connection c = connection("a.c", "a.k");
  c.convert = true;
  c.gain = 2.0;
  c.offset = 1.0;
  topology.connect(c);
  EXPECT_EQ(topology.lines()[0].gain, 2.0);
  EXPECT_EQ(topology.lines()[0].offset, 2.0 * 273.15 + 1.0);  // 2 (T + 273.15) + 1
}

TEST_F(TopologyTest, AHeldOutputNeedsNoReconstructionAndOthersDo) {
  SubsystemInfo clock{"clock", {{"reset", "1", 1, 0, 0.0}}, {{"tick", "rpm"}}, {}, {.sampled = true}, {0.1}};
  clock.outputs[0].held = true;
  topology.add("clock", clock);
  Connection held = connection("clock.tick", "shaft.speed", "");
  held.convert = true;
  topology.connect(held);
  EXPECT_EQ(topology.lines().back().how.kind, Reconstruction::Kind::held);
  held.how = Reconstruction::parse("lagrange1");
  EXPECT_TRUE(refuses_connection(held, {"clock.tick", "lagrange1", "held", "mean"}));
  EXPECT_TRUE(
      refuses_connection(connection("motor.angle", "shaft.angle", ""), {"motor.angle", "no reconstruction"}));
  EXPECT_TRUE(refuses_connection({.from = "shaft.torque",
                                  .to = "clock.reset",
                                  .how = Reconstruction::parse("matched_hold"),
                                  .convert = true},
                                 {"shaft.torque"}));
}

TEST_F(TopologyTest, GainsAndOffsetsAreFinite) {
  Connection c = connection("motor.angle", "shaft.angle");
  c.gain = NAN;
  EXPECT_TRUE(refuses_connection(c, {"motor.angle", "shaft.angle", "not finite"}));
  c.gain = 1.0;
  c.offset = INFINITY;
  EXPECT_TRUE(refuses_connection(c, {"not finite"}));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"shaft.angle", "not finite"},
                      [&] { topology.set_start("shaft.angle", NAN); }));
}

TEST_F(TopologyTest, AnInputTakesSeveralConnectionsOnlyIfAllSayAdd) {
  const Connection angle = connection("motor.angle", "shaft.angle"),
                   torque = connection("shaft.torque", "motor.torque");
  topology.connect(angle);
  EXPECT_TRUE(refuses_connection(angle, {"shaft.angle", "connected twice", "add = true"}));
  EXPECT_TRUE(refuses_connection(added(angle), {"shaft.angle", "connected twice"}))
      << "the first did not say so";
  topology.connect(added(torque));
  EXPECT_TRUE(refuses_connection(torque, {"motor.torque", "connected twice"})) << "the second did not say so";
  topology.connect(added(torque));
  EXPECT_EQ(topology.lines_to(0, 0).size(), 2U);
}

TEST_F(TopologyTest, ARefusedConnectionLeavesNothingBehind) {
  const Connection all = added(connection("shaft.forces", "shaft.loads"));
  topology.connect(connection("shaft.forces[1]", "shaft.loads[1]"));
  EXPECT_TRUE(refuses_connection(all, {"shaft.loads[1]"}));
  EXPECT_EQ(topology.lines().size(), 1U);
  topology.connect(connection("shaft.forces[0]", "shaft.loads[0]"));
  EXPECT_TRUE(
      refuses_connection(connection("shaft.forces[0]", "shaft.loads[0]"), {"shaft.loads[0]", "twice"}));
  EXPECT_TRUE(refuses_connection(added(connection("shaft.forces[0]", "shaft.loads[0]")), {"shaft.loads[0]"}))
      << "its one connection did not say add, whatever a refused one said";
}

TEST_F(TopologyTest, WhatAReconstructionNeedsHasToBeThere) {
  EXPECT_TRUE(refuses_connection(connection("shaft.torque", "motor.torque", "hermite"),
                                 {"shaft.torque", "hermite", "no derivative"}));
  EXPECT_NO_THROW(topology.connect(connection("motor.angle", "shaft.angle", "hermite")));
  for (const char* how : {"mean", "matched_hold"})
    for (const Lag lag : {Lag::memory, Lag::delay})
      EXPECT_TRUE(refuses_connection(connection("shaft.torque", "motor.torque", how, lag),
                                     {"shaft.torque", "memory or delay", how}));
}

TEST_F(TopologyTest, EveryInputIsConnectedOrHasAStartValue) {
  topology.connect(connection("motor.angle", "shaft.angle"));
  topology.connect(connection("shaft.forces[0]", "shaft.loads[0]"));
  topology.set_start("motor.torque", 1.0);
  topology.set_start("shaft.speed", 2.0);
  const auto check = [&] { topology.check(); };
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"shaft.loads[1]", "not connected", "no start value"}, check));
  topology.set_start("shaft.loads", 3.0);
  EXPECT_NO_THROW(topology.check());
  EXPECT_EQ(topology.start(1)[0], 2.0);
  EXPECT_TRUE(std::isnan(topology.start(1)[1]));
  EXPECT_EQ(topology.start(1)[4], 3.0);
}

TEST(Topology, APortsOwnStartValueWillDo) {
  const SubsystemInfo info{"s", {{"u", "1", 1, 0, 7.0}}, {}, {}, {}};
  Topology topology;
  topology.add("s", info);
  EXPECT_NO_THROW(topology.check());
  EXPECT_EQ(topology.start(0)[0], 7.0);
}

TEST_F(TopologyTest, ArraysAreConnectedWholeOrByElement) {
  topology.connect(connection("shaft.forces", "shaft.loads"));
  ASSERT_EQ(topology.lines().size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const Line& line = topology.lines()[static_cast<std::size_t>(k)];
    EXPECT_EQ(line.output, 1 + k);
    EXPECT_EQ(line.input, 2 + k);
  }
  EXPECT_EQ(topology.input_name(1, 3), "shaft.loads[1]");
  EXPECT_EQ(topology.output_name(1, 0), "shaft.torque");
  EXPECT_EQ(topology.output_name(1, 3), "shaft.forces[2]");
}

TEST_F(TopologyTest, NamesOfInstancesAreUniqueAndPlain) {
  const auto add = [&](const std::string& name) { return [this, name] { topology.add(name, motor); }; };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'motor'", "twice"}, add("motor")));
  for (const char* name : {"", "a.b", "a[0]", "a b", "a,b", "a\"b"})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'" + std::string(name) + "'"}, add(name)));
}

TEST(Topology, PortsThatContradictThemselvesAreRefused) {
  const auto adding = [](const SubsystemInfo& info) { return [info] { Topology().add("s", info); }; };
  const auto refused = [&](const SubsystemInfo& info, const std::vector<std::string>& texts) {
    return refuses(ErrorCode::invalid_argument, texts, adding(info));
  };
  EXPECT_TRUE(refused({"s", {{"u", "1", 0}}, {}, {}, {}}, {"'s'", "'u'", "size 0"}));
  EXPECT_TRUE(refused({"s", {}, {{"y", "1", 1, 4}}, {}, {}}, {"'y'", "4 derivatives"}));
  EXPECT_TRUE(refused({"s", {}, {{"y", "1", 1, -1}}, {}, {}}, {"-1 derivatives"}));
  EXPECT_TRUE(refused({"s", {}, {{"", "1"}}, {}, {}}, {"port ''"}));
  EXPECT_TRUE(refused({"s", {{"u", "1"}}, {{"y", "1"}}, {{0, 1}}, {}}, {"feedthrough", "input 1"}));
  EXPECT_TRUE(refused({"s", {{"u", "1"}}, {{"y", "1"}}, {{-1, 0}}, {}}, {"feedthrough", "output -1"}));
  EXPECT_TRUE(refused({"s", {{"u", "1"}, {"u", "1"}}, {}, {}, {}}, {"'u'", "twice"}))
      << "else the second can't be reached";
}

}  // namespace
}  // namespace tandem
