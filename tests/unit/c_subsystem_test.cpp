// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/c_subsystem.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

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

/// An oscillator of which one function is replaced; started, with room for ten rows.
struct Spoilt {
  explicit Spoilt(const std::function<void(tandem_subsystem_api&)>& spoil)
      : api(table()), subsystem((spoil(api), &api), "") {}
  void initialize() { subsystem.initialize(0.0, 1.0, u0, y); }
  void advance() { subsystem.advance(0.5, false, {&u, 1}, y); }

  tandem_subsystem_api api;
  CSubsystem subsystem;
  double memory[11 * 10] = {};
  double u0[1] = {0.0};
  Samples y{memory, 11, 10};
  Segment piece{1.0, 0.0, {}};
  Signal u{&piece, 1, 0};
};

TEST(CSubsystem, GivesUnknownCodesAndMissingSentencesAMeaning) {
  Spoilt s([](tandem_subsystem_api& api) {
    api.initialize = [](void*, double, double, const double*, tandem_samples*, tandem_clock*) {
      return static_cast<tandem_status>(7);
    };
    api.last_error = [](void*) -> const char* { return nullptr; };
  });
  EXPECT_TRUE(
      refuses(ErrorCode::internal, {"c_oscillator", "initialize", "status 7"}, [&] { s.initialize(); }));
}

TEST(CSubsystem, ChecksTheNumberOfRows) {
  for (const std::int64_t size : {-1, 0, 11}) {
    static std::int64_t answer;
    answer = size;
    Spoilt s([](tandem_subsystem_api& api) {
      api.advance = [](void*, double, std::int32_t, const tandem_signal*, tandem_samples* y,
                       tandem_clock* clock) {
        y->size = answer;
        *clock = {0.5, 1.0, TANDEM_STOP_LIMIT, 0};
        return TANDEM_OK;
      };
    });
    s.initialize();
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"c_oscillator", std::to_string(size), "1 to 10"},
                        [&] { s.advance(); }));
    EXPECT_EQ(s.y.size(), 1) << "the caller's rows are as they were";
  }
}

TEST(CSubsystem, KeepsTheRowsWhereTheyAre) {
  static void (*spoil)(tandem_samples&);
  static tandem_status status;
  const auto advanced = [](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y,
                           tandem_clock*) -> tandem_status {
    if (self) spoil(*y);
    return status;
  };
  for (const auto change :
       {+[](tandem_samples& y) { y.rows = nullptr; }, +[](tandem_samples& y) { ++y.stride; },
        +[](tandem_samples& y) { y.capacity = y.size = 20; }}) {
    spoil = change;
    Spoilt s([&](tandem_subsystem_api& api) { api.advance = advanced; });
    s.initialize();
    for (const auto code : {TANDEM_OK, TANDEM_NUMERICAL}) {
      status = code;
      const bool well = code == TANDEM_OK;
      EXPECT_TRUE(refuses(well ? ErrorCode::invalid_argument : ErrorCode::numerical,
                          {"c_oscillator", well ? "changed" : "advance"}, [&] { s.advance(); }));
      EXPECT_EQ(s.y.c_view().rows, s.memory);
      EXPECT_EQ(s.y.c_view().stride, 11);
      EXPECT_EQ(s.y.c_view().capacity, 10);
      EXPECT_EQ(s.y.size(), 1);
    }
  }
}

TEST(CSubsystem, ARowThatIsRewrittenIsToldAndPutRight) {
  Spoilt s([](tandem_subsystem_api& api) {
    api.advance = [](void*, double, std::int32_t, const tandem_signal*, tandem_samples* y,
                     tandem_clock* clock) {
      y->rows[2] += 1.0;
      *clock = {0.0, 1.0, TANDEM_STOP_LIMIT, 0};
      return TANDEM_OK;
    };
  });
  s.initialize();
  const double before = s.memory[2];
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"c_oscillator", "rewrote the row that it had given at t = 0 s"},
                      [&] { s.advance(); }));
  EXPECT_EQ(s.memory[2], before);
  EXPECT_EQ(s.y.size(), 1);
}

TEST(CSubsystem, ACreateThatGivesNothingIsTold) {
  tandem_subsystem_api api = table();
  api.create = [](const char*, void** self) {
    *self = nullptr;
    return TANDEM_OK;
  };
  EXPECT_TRUE(refuses_table(ErrorCode::invalid_argument, {"create gave no instance and no error"}, api));
}

TEST(CSubsystem, ForgetsTheRowsOfACallThatThrew) {
  Spoilt s([](tandem_subsystem_api& api) {
    api.advance = [](void*, double, std::int32_t, const tandem_signal*, tandem_samples* y,
                     tandem_clock*) -> tandem_status {
      y->size = 5;
      throw std::runtime_error("lost");
    };
  });
  s.initialize();
  EXPECT_TRUE(refuses(ErrorCode::internal, {"c_oscillator", "advance", "lost"}, [&] { s.advance(); }));
  EXPECT_EQ(s.y.size(), 1);
}

TEST(CSubsystem, ChecksTheReasonToStop) {
  Spoilt s([](tandem_subsystem_api& api) {
    api.advance = [](void*, double, std::int32_t, const tandem_signal*, tandem_samples*,
                     tandem_clock* clock) {
      *clock = {0.0, 1.0, 4, 0};
      return TANDEM_OK;
    };
  });
  s.initialize();
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"c_oscillator", "4", "0 to 3"}, [&] { s.advance(); }));
}

TEST(CSubsystem, HandsSignalsAndRowsOverAsTheyAre) {
  static const tandem_signal* seen_signal;
  static tandem_samples seen_rows;
  static std::int32_t seen_land;
  Spoilt s([](tandem_subsystem_api& api) {
    api.advance = [](void*, double, std::int32_t land, const tandem_signal* u, tandem_samples* y,
                     tandem_clock* clock) {
      seen_signal = u;
      seen_rows = *y;
      seen_land = land;
      *clock = {0.0, 1.0, TANDEM_STOP_LIMIT, 0};
      return TANDEM_OK;
    };
  });
  s.initialize();
  s.subsystem.advance(0.5, true, {&s.u, 1}, s.y);
  EXPECT_EQ(static_cast<const void*>(seen_signal), &s.u);
  EXPECT_EQ(seen_signal->segments, &s.piece);
  EXPECT_EQ(seen_rows.rows, s.memory);
  EXPECT_EQ(seen_rows.size, 1);
  EXPECT_EQ(seen_rows.capacity, 10);
  EXPECT_EQ(seen_land, 1);
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

TEST(CSubsystem, RefusesToSaveWithoutTheAbility) {
  static tandem_info poorer;
  Spoilt s([](tandem_subsystem_api& api) {
    api.info = [](void* self) -> const tandem_info* {
      poorer = *c_oscillator()->info(self);
      poorer.abilities = TANDEM_LANDS;
      return &poorer;
    };
    api.save_state = nullptr;
  });
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"c_oscillator"}, [&] { s.subsystem.save_state(); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"c_oscillator"}, [&] { s.subsystem.restore_state(0); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"c_oscillator"}, [&] { s.subsystem.release_state(0); }));
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
