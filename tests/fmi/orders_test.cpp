// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "fmus.hpp"
#include "run_bench.hpp"

namespace tandem::test {
namespace {

constexpr double t_end = 5.0;  // at 4 s the error of second derivatives passes through zero
const std::string first = "&set.k=4&set.s=1&set.d=0.3&set.m=1",
                  second = "&set.k=4&set.s=2&set.d=0.1&set.m=1.5";

/// Both masses as one linear system (x1, v1, x2, v2) from x1 = x2 = 1 at rest.
Eigen::Vector4d exact() {
  Eigen::Matrix4d a;
  a << 0.0, 1.0, 0.0, 0.0,   //
      -5.0, -0.3, 4.0, 0.0,  //
      0.0, 0.0, 0.0, 1.0,    //
      4.0 / 1.5, 0.0, -6.0 / 1.5, -0.1 / 1.5;
  const Eigen::Matrix4d over = (a * t_end).exp();
  return over * Eigen::Vector4d(1.0, 0.0, 1.0, 0.0);
}

double error_at(const std::string& fmu, const std::string& how, double h) {
  const std::string step = fmu + "?" + how + "&step=" + std::to_string(h);
  const auto one = open_fmu(step + first), other = open_fmu(step + second);
  RunBench bench;
  bench.add("one", *one).add("other", *other);
  bench.connect("one.x", "other.u", "lagrange3").connect("other.x", "one.u", "lagrange3");
  const auto& rows = bench.run(t_end);
  const auto &a = rows.rows(0).back(), &b = rows.rows(1).back();
  const Eigen::Vector4d right = exact();
  return std::max(std::abs(a[2] - right[0]), std::abs(b[2] - right[2]));
}

/// Observed between the steps 0.05 and 0.0125 s.
double order_of(const std::string& how, const std::string& fmu = "mass") {
  return std::log2(error_at(fmu, how, 0.05) / error_at(fmu, how, 0.0125)) / 2.0;
}

TEST(FmuOrders, InputsHeldAtTheLeftEndAreOfOrder1) { EXPECT_NEAR(order_of("type=cs&inputs=left"), 1.0, 0.2); }
TEST(FmuOrders, InputsHeldAtTheRightEndAreOfOrder1) {
  EXPECT_NEAR(order_of("type=cs&inputs=right"), 1.0, 0.2);
}
TEST(FmuOrders, TheMeanOverTheStepIsOfOrder2) { EXPECT_NEAR(order_of("type=cs&inputs=mean"), 2.0, 0.2); }
TEST(FmuOrders, TheMiddleOfTheStepIsOfOrder2) { EXPECT_NEAR(order_of("type=cs&inputs=middle"), 2.0, 0.2); }
TEST(FmuOrders, FirstDerivativesOfInputsAreOfOrder2) {
  EXPECT_NEAR(order_of("type=cs&inputs=derivatives&order=1"), 2.0, 0.2);
}
TEST(FmuOrders, SecondDerivativesOfInputsAreOfOrder3) {
  EXPECT_NEAR(order_of("type=cs&inputs=derivatives&order=2"), 3.0, 0.2);
}
TEST(FmuOrders, OfVersion3AreThoseOf2) {
  EXPECT_NEAR(order_of("type=cs&inputs=left", "mass3"), 1.0, 0.2);
  EXPECT_NEAR(order_of("type=cs&inputs=mean", "mass3"), 2.0, 0.2);
  EXPECT_NEAR(order_of("type=me", "mass3"), 4.0, 0.2);
}
TEST(FmuOrders, InputsThatAreAskedForAtEachStageAreOfOrder4) {
  EXPECT_NEAR(order_of("type=cs&inputs=intermediate", "mass3"), 4.0, 0.2);
}
TEST(FmuOrders, ModelExchangeIsOfOrder4) { EXPECT_NEAR(order_of("type=me"), 4.0, 0.2); }

}  // namespace
}  // namespace tandem::test
