// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sampled subsystems: in C++, behind the table of C, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "c_oscillator.h"
#include "governor.hpp"
#include "refusal.hpp"
#include "same_bits.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/c_table.hpp"
#include "tandem/check.hpp"
#include "tandem/check_info.hpp"

namespace tandem::test {
namespace {

TEST(Sampled, RunsBehindATableOfCWithTheSameBits) {
  CSubsystem plant(c_oscillator(), ""), same_plant(c_oscillator(), "");
  CSubsystem behind(c_table<governor>(), "");
  EXPECT_TRUE(behind.info().abilities.sampled);
  EXPECT_EQ(behind.info().sampling.period, 0.3);
  EXPECT_EQ(behind.info().sampling.latency, 0.02);
  EXPECT_TRUE(behind.info().outputs[0].held);
  const auto direct = governor();
  EXPECT_TRUE(same_bits(controlled(plant, behind), controlled(same_plant, *direct)));
}

TEST(Sampled, ATableWithoutItsFunctionsIsRefused) {
  tandem_subsystem_api api = *c_table<governor>();
  api.sample = nullptr;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"controller", "sampled"}, [&] { CSubsystem(&api, ""); }));
  api = *c_table<governor>();
  api.table_size = offsetof(tandem_subsystem_api, held);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"controller", "held"}, [&] { CSubsystem(&api, ""); }));
}

TEST(Sampled, ItsAdvanceMayBeMissingAndIsRefused) {
  tandem_subsystem_api api = *c_table<governor>();
  api.advance = nullptr;
  Samples y;
  CSubsystem behind(&api, "");
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"controller", "sampled"},
                      [&] { behind.advance(1.0, false, {}, y); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"controller", "sampled"},
                      [&] { governor()->advance(1.0, false, {}, y); }));
}

TEST(Sampled, ATableOfBeforeRunsAsItDid) {
  tandem_subsystem_api before = *c_oscillator();
  before.table_size = offsetof(tandem_subsystem_api, held);
  CSubsystem plant(&before, ""), same_plant(c_oscillator(), "");
  const auto first = governor(), second = governor();
  EXPECT_TRUE(same_bits(controlled(plant, *first), controlled(same_plant, *second)));
}

TEST(Sampled, WhatContradictsItselfIsRefused) {
  const auto refused = [](const auto& change, const char* text) {
    SubsystemInfo info = governor()->info();
    change(info);
    return refuses(ErrorCode::invalid_argument, {text}, [&] { check_info("it", info); });
  };
  EXPECT_TRUE(refused([](auto& i) { i.sampling.period = 0.0; }, "period of 0 s"));
  EXPECT_TRUE(refused([](auto& i) { i.sampling.latency = -1.0; }, "latency of -1 s"));
  EXPECT_TRUE(refused([](auto& i) { i.abilities.lands = true; }, "lands"));
  EXPECT_TRUE(refused([](auto& i) { i.outputs[0].held = false; }, "held"));
  EXPECT_TRUE(refused([](auto& i) { i.outputs[0].derivatives = 1; }, "derivatives"));
  EXPECT_TRUE(refused([](auto& i) { i.abilities.sampled = false; }, "is not sampled"));
  EXPECT_TRUE(refused([](auto& i) { i.inputs[0].held = true; }, "input 'u'"));
}

TEST(Sampled, IsSoundByAllChecks) {
  for (const Finding& finding : check([] { return governor(); }))
    EXPECT_EQ(finding.kind, Finding::Kind::left_out) << finding.check << ": " << finding.sentence;
}

class Hidden final : public Subsystem {
 public:
  Hidden() : info_(sound_->info()) { info_.feedthrough.clear(); }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t, double t_stop, std::span<const double> u0, Samples& y) override {
    return sound_->initialize(t, t_stop, u0, y);
  }
  Clock advance(double, bool, std::span<const Signal>, Samples&) override { return {}; }
  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override {
    return sound_->sample(t, part, u, y);
  }
  StateId save_state() override { return sound_->save_state(); }
  Clock restore_state(StateId id) override { return sound_->restore_state(id); }

 private:
  std::unique_ptr<Subsystem> sound_ = governor();
  SubsystemInfo info_;
};

TEST(Sampled, AFeedthroughThatIsNotDeclaredIsFound) {
  int wrong = 0;
  for (const Finding& finding : check([] { return std::make_unique<Hidden>(); }))
    if (finding.kind == Finding::Kind::wrong) {
      ++wrong;
      EXPECT_EQ(finding.check, "what a sampled one gives at once is declared");
      EXPECT_NE(finding.sentence.find("output y"), std::string::npos);
    }
  EXPECT_EQ(wrong, 1);
}

TEST(Sampled, APeriodThatIsNothingBesideTheEndIsRefused) {
  CSubsystem plant(c_oscillator(), "");
  const auto sampled = governor();
  RunBench bench;
  bench.add("plant", plant).add("control", *sampled);
  bench.connect("plant.x", "control.u", "lagrange3").connect("control.y", "plant.F", "");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'control'", "0.3 s", "nothing beside the end"},
                      [&] { bench.make(1e14).initialize(); }));
}

TEST(Sampled, WhatItGivesIsFiniteOrNamedWithItsInstant) {
  tandem_subsystem_api api = *c_table<governor>();
  api.sample = [](void*, double t, std::int32_t, const double*, double* y, tandem_clock* clock) {
    *y = std::nan("");
    *clock = {t, t + 0.3, TANDEM_STOP_LIMIT, 0};
    return TANDEM_OK;
  };
  CSubsystem plant(c_oscillator(), ""), sampled(&api, "");
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"'control'", "sample at t = 0.05 s", "control.y", "not finite"},
                      [&] { controlled(plant, sampled); }));
}

TEST(Sampled, HasNoPlaceInTheOrder) {
  CSubsystem plant(c_oscillator(), "");
  const auto sampled = governor();
  RunBench bench;
  bench.add("plant", plant).add("control", *sampled);
  bench.connect("plant.x", "control.u", "lagrange3").connect("control.y", "plant.F", "");
  bench.coordination.order = {"plant", "control"};
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'control'", "sampled"}, [&] { bench.make(5.0).initialize(); }));
  bench.coordination.order = {"plant"};
  EXPECT_NO_THROW(bench.make(5.0).initialize());
}

TEST(Sampled, ALoopOfFeedthroughAmongThemIsRefusedUnlessAMemoryOrALatencyBreaksIt) {
  const auto loop = [](double latency, Lag lag) {
    Sampled<Governor> a(Governor(0.0, "1")), b(Governor(latency, "1"));
    RunBench bench;
    bench.add("a", a).add("b", b);
    for (const auto& [from, to, how] : {std::tuple("a.y", "b.u", lag), {"b.y", "a.u", Lag::none}})
      bench.topology.connect({.from = from, .to = to, .how = {}, .lag = how});
    bench.topology.check();
  };
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"algebraic loop", "a.u", "b.u"}, [&] { loop(0.0, Lag::none); }));
  EXPECT_NO_THROW(loop(0.0, Lag::memory));
  EXPECT_NO_THROW(loop(0.02, Lag::none));
}

}  // namespace
}  // namespace tandem::test
