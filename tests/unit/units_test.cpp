// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/units.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <string>

namespace tandem {
namespace {

/// value in the unit `to`; within 2 ulp of what is written, for the factor and the product are each rounded.
void expect_conversion(double value, const std::string& from, double expected, const std::string& to) {
  const auto c = convert_unit(from, to);
  ASSERT_TRUE(c) << from << " to " << to;
  EXPECT_NEAR(c->factor * value + c->shift, expected, 4e-16 * std::abs(expected)) << from << " to " << to;
}

TEST(Units, ConvertWithinAQuantity) {
  expect_conversion(3000.0, "rpm", 100.0 * std::numbers::pi, "rad/s");
  expect_conversion(1.0, "rpm", 6.0, "deg/s");
  expect_conversion(180.0, "deg", std::numbers::pi, "rad");
  expect_conversion(2.0, "rev", 720.0, "deg");
  expect_conversion(1.5, "bar", 1.5e5, "Pa");
  expect_conversion(2.5, "MPa", 25.0, "bar");
  expect_conversion(1013.25, "mbar", 101.325, "kPa");
  expect_conversion(36.0, "km/h", 10.0, "m/s");
  expect_conversion(1.0, "kWh", 3.6e6, "J");
  expect_conversion(2.0, "kN m", 2000.0, "N m");
  expect_conversion(12.0, "mm", 0.012, "m");
  expect_conversion(50.0, "%", 0.5, "1");
  expect_conversion(90.0, "min", 1.5, "h");
}

TEST(Units, ShiftTemperatures) {
  expect_conversion(20.0, "degC", 293.15, "K");
  expect_conversion(293.15, "K", 20.0, "degC");
}

TEST(Units, ThereAndBackIsTheSame) {
  for (const auto& [a, b] : {std::pair{"rpm", "rad/s"}, {"bar", "Pa"}, {"degC", "K"}, {"km/h", "m/s"}}) {
    const auto there = convert_unit(a, b), back = convert_unit(b, a);
    ASSERT_TRUE(there && back);
    EXPECT_NEAR(back->factor * (there->factor * 7.0 + there->shift) + back->shift, 7.0,
                1e-13);  // 300 K eps = 7e-14
  }
}

TEST(Units, EqualTextsConvertEvenIfNobodyKnowsThem) {
  const auto c = convert_unit("furlong", "furlong");
  ASSERT_TRUE(c);
  EXPECT_EQ(c->factor, 1.0);
  EXPECT_EQ(c->shift, 0.0);
}

TEST(Units, RefuseOtherQuantitiesAndUnknownUnits) {
  EXPECT_FALSE(convert_unit("N", "N m"));
  EXPECT_FALSE(convert_unit("rpm", "Hz")) << "revolutions and hertz are kept apart";
  EXPECT_FALSE(convert_unit("m", "furlong"));
  EXPECT_FALSE(convert_unit("furlong", "m"));
  EXPECT_FALSE(convert_unit("J", "N m"));
  EXPECT_FALSE(convert_unit("", "1"));
  EXPECT_FALSE(convert_unit("RPM", "rad/s")) << "case matters";
}

TEST(Units, ConvertProducts) {
  expect_conversion(3.0, "kN m/deg", 3000.0 * 180.0 / std::numbers::pi, "N m/rad");
  expect_conversion(2.0, "N s/m", 2.0, "kg/s");
  expect_conversion(5.0, "kg mm^2", 5e-6, "kg.m2");
  expect_conversion(1.0, "1/min", 1.0 / 60.0, "Hz");
  expect_conversion(7.0, "W/(m^2 K)", 7.0, "W/m^2/degC");
  expect_conversion(4.0, "0.001 kg", 4.0, "g");
  expect_conversion(50.0, "0.5 K + 255", 280.0, "K");
  EXPECT_FALSE(convert_unit("N m/rad", "N m")) << "an angle is a unit of its own";
  EXPECT_FALSE(convert_unit("N m/rad", "N/m"));
}

TEST(Units, RefuseTextsThatAreNoProducts) {
  for (const char* text : {"", "N  m", "N m/", "/s", "N^", "N^m", "(N", "N)", "m^100", "nan", "1e999 m",
                           "-1 m", "m^1.5", "m + ", "m + x", "m + 1 m", "((((((((((m))))))))))", "((((((m99)99)99)99)99)99)", "(1e200 m)^2"})
    EXPECT_FALSE(base_unit(text)) << text;
}

/// Of random products.
TEST(Units, TextsOfProductsReadBack) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> power(-3, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    BaseUnit unit{{}, trial % 3 == 0 ? 1.0 : 0.1 * trial + 1e-3, trial % 4 == 0 ? 0.5 * trial - 100.0 : 0.0};
    for (int& exponent : unit.exponents) exponent = power(random);
    const auto again = base_unit(unit_text(unit));
    ASSERT_TRUE(again) << unit_text(unit);
    EXPECT_EQ(again->exponents, unit.exponents) << unit_text(unit);
    EXPECT_NEAR(again->factor, unit.factor, 1e-6 * unit.factor);
    EXPECT_NEAR(again->offset, unit.offset, 1e-6 * std::abs(unit.offset));
  }
}

}  // namespace
}  // namespace tandem
