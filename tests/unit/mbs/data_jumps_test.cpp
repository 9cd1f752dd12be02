// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs of a mechanism from data that jump.
#include <gtest/gtest.h>

#include "run_bench.hpp"
#include "scratch.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {
namespace {

/// 1 kg, pushed by 2 N from 0.3137 s and by -1 N from 0.7 s on.
class DataJumps : public testing::Test {
 protected:
  DataJumps() { scratch.write("push.csv", "time,F\n0,0\n0.3137,0\n0.3137,2\n0.7,2\n0.7,-1\n2,-1\n"); }

  test::Recording::Rows rows(double step, const std::string& outputs) const {
    const auto file = scratch.write(
        "mass.toml",
        "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 1 }\n[inputs]\n"
        "F = { unit = 'N', file = 'push.csv', column = 'F' }\n[forces]\n"
        "f = { point = 'P', direction = [1, 0], magnitude = 'F' }\n[outputs]\n" +
            outputs);
    const auto mass = make_subsystem(read_mechanism(file), {.step = step});
    test::RunBench bench;
    return bench.add("mass", *mass).run(1.0).all()[0];
  }
  static double exact(double t) {
    const auto after = [t](double begin) { return t > begin ? 0.5 * (t - begin) * (t - begin) : 0.0; };
    return 2.0 * after(0.3137) - 3.0 * after(0.7);
  }
  const test::Scratch scratch;
};

/// The trapezoidal rule is exact for forces that are constant between jumps, if steps end there; else it is
/// off by up to 0.02 m, of order 1.
TEST_F(DataJumps, EndPartsOfSteps) {
  for (const double step : {0.1, 0.05, 0.025}) {
    const auto all = rows(step, "x = { position = 'P.x' }\nv = { velocity = 'P.x' }\n");
    EXPECT_EQ(all.size(), static_cast<std::size_t>(1.0 / step + 1.0 + 1e-9)) << "own steps alone";
    for (const auto& row : all) EXPECT_NEAR(row[2], exact(row[0]), 1e-9) << step << " at " << row[0];
  }
}

TEST_F(DataJumps, AreJumpsOfOutputsThatFollowThem) {
  const auto all = rows(0.1, "a = { acceleration = 'P.x' }\n");
  std::vector<double> times;
  for (std::size_t k = 1; k < all.size(); ++k)
    if (all[k][1] == 1.0) {
      times.push_back(all[k][0]);
      EXPECT_EQ(all[k - 1][0], all[k][0]);
      EXPECT_NEAR(all[k][2] - all[k - 1][2], times.size() == 1 ? 2.0 : -3.0, 1e-9);
    }
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(times[0], 0.3137);
  EXPECT_NEAR(times[1], 0.7, 1e-15);
}

}  // namespace
}  // namespace tandem::mbs
