// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/c_subsystem.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "adapters.hpp"
#include "c_oscillator.h"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"

namespace tandem {
namespace {

using test::refuses;

/// The oscillator's table, to be spoilt.
tandem_subsystem_api table() { return *c_oscillator(); }

/// What the constructor says of a table.
testing::AssertionResult refuses_table(ErrorCode code, const std::vector<std::string>& texts,
                                       const tandem_subsystem_api& api) {
  return refuses(code, texts, [&] { CSubsystem(&api, ""); });
}

TEST(CSubsystem, GivesThePortsAndAbilitiesOfTheTable) {
  const CSubsystem s(c_oscillator(), "");
  const SubsystemInfo& info = s.info();
  EXPECT_EQ(info.name, "c_oscillator");
  ASSERT_EQ(info.inputs.size(), 1U);
  EXPECT_EQ(info.inputs[0].unit, "N");
  EXPECT_EQ(info.inputs[0].start, 0.0);
  ASSERT_EQ(info.outputs.size(), 3U);
  EXPECT_EQ(info.outputs[0].name, "x");
  EXPECT_EQ(info.outputs[0].derivatives, 2);
  EXPECT_EQ(info.row_size(), 2 + 3 * 3);
  ASSERT_EQ(info.feedthrough.size(), 1U);
  EXPECT_EQ(info.feedthrough[0].output, 2);
  EXPECT_TRUE(info.abilities.lands && info.abilities.saves_state && info.abilities.restarts);
  EXPECT_FALSE(info.abilities.chooses_step || info.abilities.reactive_inputs);
}

TEST(CSubsystem, RefusesATableThatItCanNotUse) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"no table"}, [] { CSubsystem(nullptr, ""); }));
  tandem_subsystem_api api = table();
  api.abi_version = 7;
  EXPECT_TRUE(refuses_table(ErrorCode::not_supported, {"ABI version 7", "1"}, api));
  api = table();
  api.table_size = 16;
  EXPECT_TRUE(refuses_table(ErrorCode::not_supported, {"16 bytes"}, api));
  api = table();
  api.advance = nullptr;
  EXPECT_TRUE(refuses_table(ErrorCode::invalid_argument, {"advance"}, api));
  api = table();
  api.restore_state = nullptr;
  EXPECT_TRUE(refuses_table(ErrorCode::invalid_argument, {"c_oscillator", "saves its state"}, api));
}

TEST(CSubsystem, TakesATableThatHasGrown) {
  struct Grown {
    tandem_subsystem_api known;
    void (*one_more)();
  } grown{table(), nullptr};
  grown.known.table_size = sizeof grown;
  EXPECT_NO_THROW(CSubsystem(&grown.known, ""));
}

TEST(CSubsystem, KnowsByItsSizeWhichFunctionsATableHas) {
  tandem_subsystem_api api = table();
  api.table_size = TANDEM_SHORTEST_TABLE;
  EXPECT_TRUE(
      refuses_table(ErrorCode::invalid_argument, {"c_oscillator", "as bytes", "has not the functions"}, api));
  api.info = [](void* self) {
    static tandem_info info = *table().info(self);
    info.abilities &= ~static_cast<std::uint32_t>(TANDEM_SERIALIZES_STATE);
    return static_cast<const tandem_info*>(&info);
  };
  CSubsystem subsystem(&api, "");
  EXPECT_TRUE(
      refuses(ErrorCode::not_supported, {"c_oscillator", "as bytes"}, [&] { subsystem.serialize_state(0); }));
}

TEST(CSubsystem, PassesOnTheCodeAndSentenceOfAnError) {
  const auto make = [](const char* parameters) {
    return [parameters] { CSubsystem(c_oscillator(), parameters); };
  };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"create", "no parameter 'mass=1'"}, make("mass=1")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"no number in 'k=stiff'"}, make("m=1&k=stiff")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"above 0"}, make("h=0")));
}

TEST(CSubsystem, HasNoNameInAnErrorOfCreate) {
  try {
    CSubsystem(c_oscillator(), "mass=1");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("create: "), 0U) << error.what();
  }
}

TEST(CSubsystem, DestroysWhatItCreatedOnceAlsoWhenItFails) {
  static int alive;
  alive = 0;
  tandem_subsystem_api api = table();
  api.create = [](const char* parameters, void** self) {
    return ++alive, c_oscillator()->create(parameters, self);
  };
  api.destroy = [](void* self) { --alive, c_oscillator()->destroy(self); };
  { const CSubsystem s(&api, ""); }
  EXPECT_EQ(alive, 0);
  EXPECT_THROW(CSubsystem(&api, "nonsense"), Error);
  EXPECT_EQ(alive, 0);
}

TEST(CSubsystem, RefusesPortListsThatAreNotThere) {
  static tandem_info broken;
  const auto make = [](const std::function<void(tandem_info&)>& spoil) {
    return [spoil] {
      broken = *c_oscillator()->info(nullptr);
      spoil(broken);
      tandem_subsystem_api api = table();
      api.info = [](void*) -> const tandem_info* { return &broken; };
      CSubsystem(&api, "");
    };
  };
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"-1 ports"}, make([](tandem_info& i) { i.input_count = -1; })));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"3 ports"}, make([](tandem_info& i) { i.outputs = nullptr; })));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"feedthrough"},
                      make([](tandem_info& i) { i.feedthrough = nullptr; })));
}

/// Takes a displacement for its force.
class Driven final : public test::Adapter {
 public:
  explicit Driven(const std::string& parameters)
      : Adapter(std::make_unique<CSubsystem>(c_oscillator(), parameters)), info_(inner_->info()) {
    info_.inputs[0].unit = "m";
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    return inner_->advance(t_limit, land, u, y);
  }

 private:
  SubsystemInfo info_;
};

/// Two oscillators in C, each driven by the other's displacement.
std::vector<test::Recording::Rows> coupled(const test::Wrap& wrap) {
  const auto fast = wrap(std::make_unique<Driven>("m=1&k=40&x0=1&h=0.01"));
  const auto slow = wrap(std::make_unique<Driven>("m=30&k=40&x0=0.3&h=0.073"));
  test::RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x", "fast.F", "lagrange3").connect("fast.x", "slow.F", "hermite");
  return bench.run(10.0).all();
}

TEST(CSubsystem, RunsUnderACoordinatorWithTheSameBitsInAnyNumberOfCalls) {
  const auto expected = coupled(test::as_it_is);
  EXPECT_EQ(expected[0].size(), 1001U);
  EXPECT_EQ(expected[0].back()[0], 10.0);
  for (const test::Wrap& wrap : {test::Wrap(test::one_step_a_call), test::Wrap(test::three_samples_a_call)})
    EXPECT_TRUE(test::same_bits(coupled(wrap), expected));
}

}  // namespace
}  // namespace tandem
