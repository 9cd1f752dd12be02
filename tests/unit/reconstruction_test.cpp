// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/reconstruction.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"

namespace tandem {
namespace {

TEST(Reconstruction, NamesAreReadAndWrittenAlike) {
  std::vector<std::string> names = {"hermite", "mean", "matched_hold"};
  for (int d = 0; d <= 4; ++d) {
    names.push_back("lagrange" + std::to_string(d));
    for (int extra = 1; extra <= 16; ++extra)
      names.push_back("least_squares" + std::to_string(d) + "_" + std::to_string(extra));
  }
  for (const std::string& name : names) EXPECT_EQ(Reconstruction::parse(name).name(), name);
}

TEST(Reconstruction, ANameSaysKindDegreeAndExtraSamples) {
  EXPECT_EQ(Reconstruction::parse("lagrange3"), (Reconstruction{Reconstruction::Kind::lagrange, 3, 0}));
  EXPECT_EQ(Reconstruction::parse("least_squares2_4"),
            (Reconstruction{Reconstruction::Kind::least_squares, 2, 4}));
  EXPECT_EQ(Reconstruction::parse("least_squares1_16").extra, 16);
  EXPECT_EQ(Reconstruction::parse("matched_hold"), Reconstruction{Reconstruction::Kind::matched_hold});
}

TEST(Reconstruction, AnyOtherNameIsRefusedWithTheListOfThem) {
  for (const std::string name : {"lagrange5",
                                 "lagrange-1",
                                 "lagrange03",
                                 "lagrange",
                                 "lagrange1.5",
                                 "lagrange3 ",
                                 " lagrange3",
                                 "Lagrange3",
                                 "lagrange99999999999",
                                 "least_squares5_2",
                                 "least_squares2_0",
                                 "least_squares2_17",
                                 "least_squares2",
                                 "least_squares2_",
                                 "least_squares_2",
                                 "least_squares02_3",
                                 "least_squares2_03",
                                 "least_squares2_3_4",
                                 "means",
                                 "mean3",
                                 "hermite3",
                                 "matched hold",
                                 "impulse",
                                 ""})
    EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument,
                              {"'" + name + "'", "lagrange0 to lagrange4", "hermite", "mean",
                               "least_squaresD_EXTRA", "matched_hold"},
                              [&] { Reconstruction::parse(name); }));
}

TEST(Reconstruction, TakesAsManySamplesAsItsPolynomialNeeds) {
  EXPECT_EQ(Reconstruction::parse("lagrange0").samples(), 1);
  EXPECT_EQ(Reconstruction::parse("lagrange4").samples(), 5);
  EXPECT_EQ(Reconstruction::parse("hermite").samples(), 2);
  EXPECT_EQ(Reconstruction::parse("least_squares2_4").samples(), 7);
  EXPECT_EQ(Reconstruction::parse("hermite").polynomial_degree(), 3);
  EXPECT_EQ(Reconstruction::parse("least_squares2_4").polynomial_degree(), 2);
  EXPECT_EQ(Reconstruction::parse("mean").polynomial_degree(), 0);
}

TEST(Reconstruction, OrderDPlus1TakesDMinus1DerivativesAtTheStart) {
  for (int d = 0; d <= 4; ++d) {
    EXPECT_EQ(Reconstruction::parse("lagrange" + std::to_string(d)).derivatives_at_start(),
              std::max(0, d - 1));
    EXPECT_EQ(Reconstruction::parse("least_squares" + std::to_string(d) + "_2").derivatives_at_start(),
              std::max(0, d - 1));
  }
  EXPECT_EQ(Reconstruction::parse("hermite").derivatives_at_start(), 2);
  EXPECT_EQ(Reconstruction::parse("hermite").derivatives_read(), 1);
  EXPECT_EQ(Reconstruction::parse("lagrange4").derivatives_read(), 0);
}

TEST(Reconstruction, MeanAndMatchedHoldDependOnTheReader) {
  EXPECT_FALSE(Reconstruction::parse("mean").follows_samples());
  EXPECT_FALSE(Reconstruction::parse("matched_hold").follows_samples());
  for (const char* name : {"lagrange0", "hermite", "least_squares0_1"})
    EXPECT_TRUE(Reconstruction::parse(name).follows_samples());
}

}  // namespace
}  // namespace tandem
