// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Saved states of models in C by tandem/fixed_step.h.
#include <gtest/gtest.h>

#include "c_models.h"
#include "refusal.hpp"
#include "tandem/c_subsystem.hpp"

namespace tandem {
namespace {

using test::refuses;

class CModelStates : public testing::Test {
 protected:
  CModelStates() { start(integral); }

  static void start(Subsystem& s) {
    double row[4], u0 = 0.0;
    Samples y(row, 4, 1);
    s.initialize(0.5, 1000.0, {&u0, 1}, y);
  }
  /// The rows up to the limit, landing.
  std::vector<double> to(Subsystem& s, double limit) {
    Samples y(memory_, 4, 100);
    s.advance(limit, true, {&u_, 1}, y);
    return {memory_, memory_ + 4 * y.size()};
  }

  CSubsystem integral{c_integral(), ""};

 private:
  double memory_[400] = {};
  Segment line_{1e9, 0.0, {1.0, 0.3}};
  Signal u_{&line_, 1, 1};
};

TEST_F(CModelStates, ManyAreKeptAndEachIsPutBackWithItsPlace) {
  std::vector<StateId> ids;
  std::vector<std::vector<double>> after;
  for (int k = 0; k < 50; ++k) {
    ids.push_back(integral.save_state());
    after.push_back(to(integral, 0.5 + 0.13 * (k + 1)));  // most of them amid a step
  }
  for (const int k : {49, 0, 17, 3, 48, 3}) {
    EXPECT_EQ(integral.restore_state(ids[static_cast<std::size_t>(k)]).time, k == 0 ? 0.5 : 0.5 + 0.13 * k);
    EXPECT_EQ(to(integral, 0.5 + 0.13 * (k + 1)), after[static_cast<std::size_t>(k)]) << k;
  }
}

TEST_F(CModelStates, TheMemoryOfOneThatIsReleasedIsUsedAgain) {
  const StateId first = integral.save_state(), second = integral.save_state();
  integral.release_state(first);
  for (int k = 0; k < 1000; ++k) integral.release_state(integral.save_state());
  EXPECT_EQ(integral.save_state(), first);
  EXPECT_NE(first, second);
}

TEST_F(CModelStates, OneThatIsNotThereIsRefused) {
  const StateId id = integral.save_state();
  integral.release_state(id);
  for (const StateId none : {id, id + 1, StateId{-1}, StateId{1} << 40}) {
    const std::string sentence = "there is no saved state " + std::to_string(none);
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {sentence}, [&] { integral.restore_state(none); }));
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {sentence}, [&] { integral.release_state(none); }));
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {sentence}, [&] { integral.serialize_state(none); }));
  }
}

TEST_F(CModelStates, AsBytesItGoesOnInAnotherInstance) {
  to(integral, 1.234);
  const auto bytes = integral.serialize_state(integral.save_state());
  CSubsystem other(c_integral(), "");
  start(other);
  EXPECT_EQ(other.restore_state(other.deserialize_state(bytes)).time, 1.234);
  EXPECT_EQ(to(other, 3.0), to(integral, 3.0));
}

/// Also where a node is not rounded as the one before and a step are.
TEST_F(CModelStates, AsBytesItIsTakenAtEachNode) {
  CSubsystem other(c_integral(), "");
  start(other);
  for (int k = 1; k <= 2000; ++k) {
    to(integral, 0.5 + k * 0.1);
    const StateId id = integral.save_state();
    StateId there = 0;
    ASSERT_NO_THROW(there = other.deserialize_state(integral.serialize_state(id))) << k;
    integral.release_state(id);
    other.release_state(there);
  }
}

TEST_F(CModelStates, BytesOfAnotherGridOrOfNoneAreRefused) {
  const auto bytes = integral.serialize_state(integral.save_state());
  const auto refused = [](Subsystem& s, std::span<const std::byte> state) {
    return refuses(ErrorCode::invalid_argument, {"the state is none of this model with these own steps"},
                   [&] { s.deserialize_state(state); });
  };
  EXPECT_TRUE(refused(integral, std::span(bytes).first(bytes.size() - 1)));
  CSubsystem faster(c_integral(), "h=0.05"), larger(c_switch(), "h=0.1");
  start(faster);
  start(larger);
  EXPECT_TRUE(refused(faster, bytes));
  EXPECT_TRUE(refused(larger, bytes));
  auto later = bytes;
  const double t = 0.7;  // past the next node
  std::memcpy(later.data() + 2 * sizeof t, &t, sizeof t);
  EXPECT_TRUE(refused(integral, later));
}

}  // namespace
}  // namespace tandem
