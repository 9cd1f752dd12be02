// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "subsystem_c_layout.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <type_traits>

#include "tandem/error.hpp"
#include "tandem/signal.hpp"
#include "tandem/subsystem.hpp"

extern "C" {
extern const size_t layout_in_c[];
extern const size_t layout_in_c_count;
}

namespace tandem {
namespace {

TEST(SubsystemCLayout, IsTheSameInCAndCpp) {
  constexpr std::size_t layout[] = LAYOUT;
  ASSERT_EQ(layout_in_c_count, std::size(layout));
  for (std::size_t i = 0; i < std::size(layout); ++i) EXPECT_EQ(layout_in_c[i], layout[i]) << "entry " << i;
}

TEST(SubsystemCLayout, IsThatOfAbiVersion1) {
  EXPECT_EQ(TANDEM_ABI_VERSION, 1);
  EXPECT_EQ(sizeof(tandem_segment), 64U);
  EXPECT_EQ(sizeof(tandem_signal), 24U);
  EXPECT_EQ(sizeof(tandem_samples), 32U);
  EXPECT_EQ(sizeof(tandem_clock), 24U);
  EXPECT_EQ(sizeof(tandem_port), 32U);
  EXPECT_EQ(sizeof(tandem_info), 48U);
  EXPECT_EQ(offsetof(tandem_subsystem_api, create), 8U);
  EXPECT_EQ(TANDEM_SHORTEST_TABLE, 8U + 9U * sizeof(void*));
  EXPECT_EQ(offsetof(tandem_subsystem_api, held), 8U + 11U * sizeof(void*));
  EXPECT_EQ(offsetof(tandem_subsystem_api, parameters), 8U + 14U * sizeof(void*));
  EXPECT_EQ(sizeof(tandem_subsystem_api), 8U + 16U * sizeof(void*));
  EXPECT_EQ(sizeof(tandem_parameter), 4U * sizeof(void*));
}

TEST(SubsystemCLayout, ASpanOfSignalsIsAnArrayOfTheCType) {
  EXPECT_TRUE(std::is_standard_layout_v<Signal> && std::is_trivially_copyable_v<Signal>);
  const Segment s{2.0, 1.0, {3.0, 4.0}};
  const Signal signals[] = {Signal(&s, 1, 0), Signal(&s, 1, 1)};
  const auto* c = reinterpret_cast<const tandem_signal*>(signals);
  EXPECT_EQ(c[1].segments, &s);
  EXPECT_EQ(c[1].count, 1);
  EXPECT_EQ(c[1].degree, 1);
  EXPECT_EQ(c[1].reactive, nullptr);
}

TEST(SubsystemCLayout, CodesAreTheSameInCAndCpp) {
  EXPECT_EQ(static_cast<int>(ErrorCode::invalid_argument), TANDEM_INVALID_ARGUMENT);
  EXPECT_EQ(static_cast<int>(ErrorCode::not_supported), TANDEM_NOT_SUPPORTED);
  EXPECT_EQ(static_cast<int>(ErrorCode::wrong_state), TANDEM_WRONG_STATE);
  EXPECT_EQ(static_cast<int>(ErrorCode::numerical), TANDEM_NUMERICAL);
  EXPECT_EQ(static_cast<int>(ErrorCode::input_output), TANDEM_INPUT_OUTPUT);
  EXPECT_EQ(static_cast<int>(ErrorCode::internal), TANDEM_INTERNAL);
  EXPECT_EQ(static_cast<int>(Stop::finished), TANDEM_STOP_FINISHED);
}

}  // namespace
}  // namespace tandem
