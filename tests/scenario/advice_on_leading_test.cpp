// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "linear_controller.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"
#include "tandem/advice/leading.hpp"
#include "tandem/scenario/assembly.hpp"
#include "two_mass/masses.hpp"

namespace tandem::advice {
namespace {

std::vector<std::string> advice_for(const std::string& file, const std::vector<std::string>& overrides) {
  Builtins builtins;
  two_mass::add_builtins(builtins);
  const auto one = scenario::read(std::string(TANDEM_SOURCE_DIR) + "/scenarios/two_mass/" + file, overrides);
  scenario::Assembly assembly(one, builtins);
  assembly.initialize();
  return on_leading(assembly.coordinator());
}

TEST(AdviceOnLeading, TellsOfAForceOfTheLeaderThatComesRound) {
  EXPECT_EQ(advice_for("force_plain.toml", {}).size(), 0U);
  const auto lines = advice_for("force_plain.toml", {"coordination.schedule=fastest-first"});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(
      lines[0],
      "output fast.F depends at once on input fast.x2, which 'fast' extrapolates, as it leads in schedule "
      "fastest-first; what that errs by is in the output at once, and comes round over 'slow'");
}

TEST(AdviceOnLeading, InParallelNobodyLeads) {
  EXPECT_EQ(advice_for("force_plain.toml", {"coordination.schedule=parallel"}).size(), 0U);
}

TEST(AdviceOnLeading, WithoutFeedthroughThereIsNone) {
  EXPECT_EQ(advice_for("two_mass.toml", {"coordination.schedule=fastest-first"}).size(), 0U);
}

/// Of a ring a -> b -> c -> a, in which `a` leads and feeds through; b or c may be sampled.
class RingAdvice : public testing::Test {
 protected:
  std::vector<std::string> advice_of(char sampled, const std::string& schedule = "slowest-first") {
    test::RunBench bench;
    Subsystem &b = sampled == 'b' ? static_cast<Subsystem&>(control_) : b_,
              &c = sampled == 'c' ? static_cast<Subsystem&>(control_) : c_;
    bench.add("a", a_).add("b", b).add("c", c).schedule(schedule);
    bench.connect("a.y", "b.u", "lagrange1");
    bench.connect("b.y", "c.u", sampled == 'b' ? "" : "lagrange1");
    bench.connect("c.y", "a.u", sampled == 'c' ? "" : "lagrange1");
    bench.make(4.0).initialize();
    return on_leading(*bench.coordinator);
  }
  static test::Linear half() {
    const auto one = [](double value) { return test::MatrixXd::Constant(1, 1, value); };
    return {one(0.5), one(0.5), one(1.0), one(0.0), test::VectorXd::Zero(1)};
  }

  test::Scripted a_ = test::mirror(0.4), b_ = test::listener(0.3), c_ = test::listener(0.2);
  Sampled<test::LinearController> control_{test::LinearController(half(), {0.5})};
};

TEST_F(RingAdvice, IsGivenForRingsOfAnyLength) {
  ASSERT_EQ(advice_of(' ').size(), 1U);
  EXPECT_NE(advice_of(' ')[0].find("output a.y depends at once on input a.u"), std::string::npos);
  EXPECT_NE(advice_of(' ')[0].find("comes round over 'b', 'c'"), std::string::npos) << advice_of(' ')[0];
  EXPECT_EQ(advice_of(' ', "fastest-first").size(), 0U) << "it follows";
}

TEST_F(RingAdvice, GoesOverSampledOnesButNotWhereAHeldInputClosesTheRing) {
  ASSERT_EQ(advice_of('b').size(), 1U);
  EXPECT_NE(advice_of('b')[0].find("comes round over 'b', 'c'"), std::string::npos);
  EXPECT_EQ(advice_of('c').size(), 0U);
}

/// A relay of 0.1 s that a slower plant reads, which a third one reads.
std::vector<std::string> advice_for_relay(const std::string& schedule, std::vector<std::string> order) {
  SubsystemInfo info = test::listener(0.1).info();
  info.abilities.events = true;
  test::Scripted relay(info, 0.1, [](double, const auto&, double* y) { y[0] = 0.0; });
  test::Scripted plant = test::listener(0.3), third = test::listener(0.2);
  test::RunBench bench;
  bench.add("plant", plant).add("relay", relay).add("third", third).schedule(schedule);
  bench.connect("plant.y", "relay.u", "lagrange1").connect("relay.y", "plant.u", "lagrange1");
  bench.connect("plant.y", "third.u", "lagrange1");
  bench.coordination.order = std::move(order);
  bench.make(4.0).initialize();
  return on_leading(*bench.coordinator);
}

TEST(AdviceOnLeading, LetsWhoSwitchesLeadItsReaders) {
  ASSERT_EQ(advice_for_relay("slowest-first", {}).size(), 1U);
  EXPECT_EQ(advice_for_relay("slowest-first", {})[0],
            "'relay' with events should lead who reads them, which then ends its steps there: "
            "coordination.order = [\"relay\", \"plant\", \"third\"]");
  EXPECT_EQ(advice_for_relay("slowest-first", {"relay", "plant", "third"}).size(), 0U);
  EXPECT_EQ(advice_for_relay("fastest-first", {}).size(), 0U);
  ASSERT_EQ(advice_for_relay("fastest-first", {"third", "relay", "plant"}).size(), 1U);
  EXPECT_NE(advice_for_relay("fastest-first", {"third", "relay", "plant"})[0].find(
                "[\"third\", \"plant\", \"relay\"]"),
            std::string::npos)
      << "named slowest first all the same";
  EXPECT_EQ(advice_for_relay("parallel", {}).size(), 0U);
}

}  // namespace
}  // namespace tandem::advice
