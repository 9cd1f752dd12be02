// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who leads where own steps are equal: by what the subsystems are, never by the order of the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "relay_scene.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scripted.hpp"

namespace tandem {
namespace {

using test::RunBench;
using test::Scripted;

/// With the output 0.1 (its first input, or time) + 1.
Scripted subsystem(const std::string& kind, double step = 0.5) {
  SubsystemInfo info{kind, {{"u", "1", 1, 0}}, {{"y", "1"}}, {}, {.restarts = true}};
  info.inputs[0].start = 0.0;
  info.abilities.events = kind == "switches";
  if (kind == "feeds") info.feedthrough = {{0, 0}};
  const bool feeds = kind == "feeds";
  return {info, step, [feeds](double t, const auto& u, double* y) { y[0] = 0.1 * (feeds ? u[0] : t) + 1.0; }};
}

/// "b" feeds through, "c" and "d" are plain, "e" switches: in a ring b -> c -> d -> e -> b, all at 0.5 s.
class TieOrder : public testing::Test {
 protected:
  RunBench& run(const std::vector<int>& file, const std::string& schedule) {
    bench_ = std::make_unique<RunBench>();
    for (const int k : file) bench_->add(names_[k], all_[static_cast<std::size_t>(k)]);
    for (int k = 0; k < 4; ++k) bench_->connect(names_[k] + ".y", names_[(k + 1) % 4] + ".u", "lagrange2");
    bench_->schedule(schedule).run(6.0);
    return *bench_;
  }
  static std::vector<std::string> order(const RunBench& bench) {
    std::vector<std::string> names;
    for (const int i : bench.coordinator->schedule().order()) names.push_back(bench.topology.name(i));
    return names;
  }
  /// Rows by name.
  std::vector<test::Recording::Rows> rows(const std::vector<int>& file) const {
    std::vector<test::Recording::Rows> all(4);
    for (std::size_t p = 0; p < file.size(); ++p)
      all[static_cast<std::size_t>(file[p])] = bench_->recording.all()[p];
    return all;
  }

 private:
  const std::string names_[4] = {"b", "c", "d", "e"};
  std::vector<Scripted> all_ = {subsystem("feeds"), subsystem("plain"), subsystem("plain"),
                                subsystem("switches")};
  std::unique_ptr<RunBench> bench_;
};

TEST_F(TieOrder, WhoSwitchesLeadsAndWhoFeedsThroughFollowsInAnyOrderOfTheFile) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    std::vector<int> file = {0, 1, 2, 3};
    run(file, schedule);
    const auto expected = rows(file);
    while (std::next_permutation(file.begin(), file.end())) {
      EXPECT_EQ(order(run(file, schedule)), (std::vector<std::string>{"e", "c", "d", "b"})) << schedule;
      EXPECT_TRUE(test::same_bits(rows(file), expected)) << schedule;
    }
  }
}

TEST_F(TieOrder, IsToldWithTheKeyThatChoosesWhereItMatters) {
  const auto& notes = run({2, 0, 1, 3}, "slowest-first").coordinator->notes();
  const auto told = std::count_if(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find(
               "subsystems 'e', 'c', 'd', 'b' have the same own step and lead in this order, as who "
               "switches leads") != std::string::npos &&
           note.find("coordination.order") != std::string::npos;
  });
  EXPECT_EQ(told, 1);
  for (const std::string& note : run({2, 0, 1, 3}, "parallel").coordinator->notes())
    EXPECT_EQ(note.find("the same own step"), std::string::npos) << note;
}

TEST(Ties, AreBrokenByNameBetweenEqualsAndNotToldOfThoseThatDoNotMeet) {
  for (const bool meet : {true, false}) {
    Scripted a = subsystem("plain"), b = subsystem("plain");
    RunBench bench;
    bench.add("b", b).add("a", a).schedule("slowest-first");
    if (meet) bench.connect("a.y", "b.u", "lagrange1").connect("b.y", "a.u", "lagrange1");
    bench.run(2.0);
    EXPECT_EQ(bench.coordinator->schedule().order()[0], 1);
    std::string notes;
    for (const std::string& note : bench.coordinator->notes()) notes += note + "\n";
    EXPECT_EQ(notes.find("subsystems 'a', 'b' have the same own step and lead in this order, by name") !=
                  std::string::npos,
              meet)
        << notes;
  }
}

TEST(Ties, AreOfStepsThatDifferByRoundingToo) {
  for (const double t_start : {0.0, 1e5}) {
    Scripted a = subsystem("plain", 0.1 + 0.2), b = subsystem("plain", 0.3);
    RunBench bench;
    bench.add("b", b).add("a", a).connect("a.y", "b.u", "lagrange1").schedule("slowest-first");
    bench.run(t_start + 3.0, t_start);
    EXPECT_EQ(bench.coordinator->schedule().order()[0], 1) << t_start;
  }
}

TEST(Ties, AHeldInputThatFeedsThroughMakesItsReaderLead) {
  Scripted a = subsystem("plain"), b = subsystem("feeds");
  SubsystemInfo relay = subsystem("switches").info();
  relay.outputs[0].held = true;
  Scripted c(relay, 0.25, [](double, const auto&, double* y) { y[0] = 1.0; });
  RunBench bench;
  bench.add("a", a).add("b", b).add("c", c).schedule("slowest-first");
  bench.connect("c.y", "b.u", "").connect("b.y", "a.u", "lagrange1").run(2.0);
  EXPECT_EQ(bench.coordinator->schedule().order()[0], 1);
}

TEST(Ties, ARelayLeadsItsPlantThoughItsNameComesLater) {
  test::RelayRun what;
  what.system.jump = 0.3;
  what.relay_step = what.plant_step = 0.02;
  what.order = {"relay", "plant"};
  test::RelayBench relay_first(what);
  const double expected = relay_first.error(relay_first.run());
  what.order = {};
  what.schedule = "fastest-first";
  test::RelayBench by_rule(what);
  EXPECT_EQ(by_rule.error(by_rule.run()), expected);
}

}  // namespace
}  // namespace tandem
