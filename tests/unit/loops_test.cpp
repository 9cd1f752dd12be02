// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "connection.hpp"
#include "refusal.hpp"
#include "tandem/coordinator/topology.hpp"

namespace tandem {
namespace {

using test::added;
using test::connection;

/// u1 feeds y1 through, u2 does not feed anything through.
const SubsystemInfo block{"block", {{"u1", "1"}, {"u2", "1"}}, {{"y1", "1"}, {"y2", "1"}}, {{0, 0}}, {}};

/// Three blocks a, b and c. All inputs have a start value.
class Loops : public testing::Test {
 protected:
  Loops() {
    for (const char* name : {"a", "b", "c"}) {
      topology.add(name, block);
      topology.set_start(std::string(name) + ".u1", 0.0);
      topology.set_start(std::string(name) + ".u2", 0.0);
    }
  }
  void connect(const std::string& from, const std::string& to, Lag lag = Lag::none) {
    topology.connect(connection(from, to, "lagrange0", lag));
  }
  testing::AssertionResult refuses_loop(const std::string& cycle) {
    return test::refuses(ErrorCode::invalid_argument,
                         {"algebraic loop", cycle, "memory = true or delay = true"},
                         [this] { topology.check(); });
  }
  Topology topology;
};

TEST_F(Loops, OfDirectFeedthroughAreRefusedWithTheirCycle) {
  connect("a.y1", "b.u1");
  connect("b.y1", "c.u1");
  connect("c.y1", "a.u1");
  EXPECT_TRUE(refuses_loop("a.u1 -> a.y1 -> b.u1 -> b.y1 -> c.u1 -> c.y1 -> a.u1"));
}

TEST_F(Loops, TakeEveryFeedthroughOfACycle) {
  connect("a.y1", "b.u1");
  connect("b.y1", "c.u1");
  connect("c.y1", "b.u2");
  EXPECT_NO_THROW(topology.check());
  connect("c.y1", "a.u1");
  EXPECT_TRUE(refuses_loop("a.u1"));
}

TEST_F(Loops, MayBeOfOneSubsystemWithItself) {
  connect("b.y1", "b.u1");
  EXPECT_TRUE(refuses_loop(": b.u1 -> b.y1 -> b.u1;"));
}

TEST(LoopsOfSums, AreFoundAndTheWayIntoThemIsLeftOut) {
  Topology other;
  for (const char* name : {"a", "b", "c"})
    other.add(name, block), other.set_start(std::string(name) + ".u2", 0.0);
  other.set_start("a.u1", 0.0);
  other.connect(added(connection("a.y1", "b.u1")));
  other.connect(connection("b.y1", "c.u1"));
  other.connect(added(connection("c.y1", "b.u1")));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {": b.u1 -> b.y1 -> c.u1 -> c.y1 -> b.u1;"},
                            [&] { other.check(); }));
}

TEST_F(Loops, WithoutFeedthroughAreNone) {
  connect("a.y2", "b.u1");
  connect("b.y1", "a.u1");
  EXPECT_NO_THROW(topology.check());
}

TEST_F(Loops, AreBrokenByAMemoryOrADelayAnywhereInThem) {
  for (const Lag lag : {Lag::memory, Lag::delay})
    for (int broken = 0; broken < 3; ++broken) {
      Topology t;
      for (const char* name : {"a", "b", "c"})
        t.add(name, block), t.set_start(std::string(name) + ".u2", 0.0);
      const char* lines[][2] = {{"a.y1", "b.u1"}, {"b.y1", "c.u1"}, {"c.y1", "a.u1"}};
      for (int k = 0; k < 3; ++k)
        t.connect(connection(lines[k][0], lines[k][1], "lagrange0", k == broken ? lag : Lag::none));
      EXPECT_NO_THROW(t.check());
    }
}

TEST_F(Loops, OfWhichOneOfTwoIsBrokenIsStillRefused) {
  connect("a.y1", "b.u1");
  connect("b.y1", "a.u1", Lag::memory);
  EXPECT_NO_THROW(topology.check());
  connect("c.y1", "c.u1");
  EXPECT_TRUE(refuses_loop(": c.u1 -> c.y1 -> c.u1;"));
}

}  // namespace
}  // namespace tandem
