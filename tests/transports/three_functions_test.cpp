// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/shared_library/three_functions.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "three_functions.hpp"

namespace tandem::test {
namespace {

TEST(ThreeFunctions, TakesTheInputsOfTheBeginningOfEachStep) {
  const auto subsystem = open_three(its_ports);
  EXPECT_EQ(subsystem->info().outputs[0].unit, "rad");
  EXPECT_EQ(subsystem->info().inputs[0].unit, "N m");
  std::vector<double> memory(4 * 101);
  Samples y(memory.data(), 4, 101);
  const double u0 = 0.0;
  subsystem->initialize(0.0, 1.0, {&u0, 1}, y);
  const Segment ramp{1.0, 0.0, {0.5, 2.0}};
  const Signal u(&ramp, 1, 1);
  subsystem->advance(1.0, false, {&u, 1}, y);
  ASSERT_EQ(y.size(), 101);
  double x = 1.0;
  for (int k = 0; k <= 100; ++k) {
    EXPECT_EQ(y.time(k), k * 0.01);
    EXPECT_EQ(y.values(k)[0], x) << k;
    EXPECT_EQ(y.values(k)[1], k > 0 ? u.value((k - 1) * 0.01) : 0.0);
    x += 0.01 * (u.value(k * 0.01) - x);
  }
}

TEST(ThreeFunctions, WhatIsWrongIsRefused) {
  const auto code = ErrorCode::invalid_argument;
  EXPECT_TRUE(
      refuses(code, {"three_functions", "'begin'"}, [] { open_three(its_ports + "&initiate=begin"); }));
  EXPECT_TRUE(refuses(code, {"step", "above 0"}, [] { open_three("outputs=x:rad=1"); }));
  EXPECT_TRUE(refuses(code, {"outputs", "'x:rad'", "=value"}, [] { open_three("step=0.01&outputs=x:rad"); }));
  EXPECT_TRUE(refuses(code, {"inputs", "':N'"}, [] { open_three("step=0.01&inputs=:N"); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"no.so", "is not there"},
                      [] { open("three_functions:/no.so?step=1", library_sources()); }));
}

}  // namespace
}  // namespace tandem::test
