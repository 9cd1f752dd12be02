// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a library in C says of its rows, clocks and errors is checked.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "c_oscillator.h"
#include "refusal.hpp"
#include "tandem/c_subsystem.hpp"

namespace tandem {
namespace {

using test::refuses;

/// An oscillator of which one function is replaced; started, with room for ten rows.
struct Spoilt {
  explicit Spoilt(const std::function<void(tandem_subsystem_api&)>& spoil)
      : api(*c_oscillator()), subsystem((spoil(api), &api), "") {}
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

TEST(CSubsystemReplies, GivesUnknownCodesAndMissingSentencesAMeaning) {
  Spoilt s([](tandem_subsystem_api& api) {
    api.initialize = [](void*, double, double, const double*, tandem_samples*, tandem_clock*) {
      return static_cast<tandem_status>(7);
    };
    api.last_error = [](void*) -> const char* { return nullptr; };
  });
  EXPECT_TRUE(
      refuses(ErrorCode::internal, {"c_oscillator", "initialize", "status 7"}, [&] { s.initialize(); }));
}

TEST(CSubsystemReplies, ChecksTheNumberOfRows) {
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

TEST(CSubsystemReplies, KeepsTheRowsWhereTheyAre) {
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

TEST(CSubsystemReplies, ARowThatIsRewrittenIsToldAndPutRight) {
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

TEST(CSubsystemReplies, ACreateThatGivesNothingIsTold) {
  tandem_subsystem_api api = *c_oscillator();
  api.create = [](const char*, void** self) {
    *self = nullptr;
    return TANDEM_OK;
  };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"create gave no instance and no error"},
                      [&] { CSubsystem(&api, ""); }));
}

TEST(CSubsystemReplies, ForgetsTheRowsOfACallThatThrew) {
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

TEST(CSubsystemReplies, ChecksTheReasonToStop) {
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

TEST(CSubsystemReplies, HandsSignalsAndRowsOverAsTheyAre) {
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

TEST(CSubsystemReplies, RefusesToSaveWithoutTheAbility) {
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

}  // namespace
}  // namespace tandem
