// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Steps of large models whose loops threads share.
#include <gtest/gtest.h>

#include "four_bar/linkage.hpp"
#include "refusal.hpp"
#include "solver_bench.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "this_process.hpp"

namespace tandem::mbs {
namespace {

/// Where the linkage is after five steps, and the accelerations and multipliers there.
State after_five_steps(Mechanism& linkage, const Index3Settings& settings) {
  Index3 stepper(linkage, settings);
  State s = linkage.described_state();
  stepper.start(s);
  for (int k = 1; k <= 5; ++k) stepper.step(s, 1e-3, 1e-3 * k);
  return s;
}

TEST(Threads, GiveTheSameBitsWhateverTheirNumber) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(2100)));
  Index3Settings settings{.penalty = 1e8, .threads_from = 4000};  // constraints are coloured from there on
  const State alone = after_five_steps(linkage, settings);
  for (const int threads : {2, 3, 4}) {
    settings.threads = threads;
    if (!threads_are_built_in()) {
      EXPECT_TRUE(test::refuses(ErrorCode::not_supported, {"threads", "without OpenMP"},
                                [&] { Index3(linkage, settings); }));
      continue;
    }
    const State shared = after_five_steps(linkage, settings);
    EXPECT_EQ(shared.q, alone.q) << threads;
    EXPECT_EQ(shared.v, alone.v) << threads;
    EXPECT_EQ(shared.a, alone.a) << threads;
    EXPECT_EQ(shared.lambda, alone.lambda) << threads;
  }
}

/// Each loop of a small linkage, and no loop of a large one. By one thread without OpenMP.
TEST(Threads, GiveTheSameBitsFromWhateverSizeOn) {
  const int threads = threads_are_built_in() ? 3 : 1;
  for (const auto& [loops, from] : {std::pair(30, 1), {30, 50}, {2100, 100000}}) {
    Mechanism linkage(read_mechanism("linkage", four_bar::text(loops)));
    const State alone = after_five_steps(linkage, {.penalty = 1e8});
    const State shared =
        after_five_steps(linkage, {.penalty = 1e8, .threads = threads, .threads_from = from});
    EXPECT_EQ(shared.q, alone.q) << loops << " " << from;
    EXPECT_EQ(shared.v, alone.v) << loops << " " << from;
    EXPECT_EQ(shared.lambda, alone.lambda) << loops << " " << from;
  }
}

/// Eigen shares dense products among all cores unless it is told not to.
TEST(Threads, NoneIsMadeThatNobodyAskedFor) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Identity(400, 400) + Eigen::MatrixXd::Constant(400, 400, 0.1);
  const std::ptrdiff_t before = test::running_threads();
  EXPECT_EQ(test::SolverBench("eigen_dense", MatrixKind::unsymmetric, test::pattern_of(a)).factorize(a), -1);
  EXPECT_EQ(test::running_threads(), before);
}

TEST(Threads, AreAtLeastOne) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(1)));
  EXPECT_TRUE(
      test::refuses(ErrorCode::invalid_argument, {"threads", "0"}, [&] { Index3(linkage, {.threads = 0}); }));
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"threads_from", "0"},
                            [&] { Index3(linkage, {.threads_from = 0}); }));
}

}  // namespace
}  // namespace tandem::mbs
