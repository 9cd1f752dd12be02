// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Which start is chosen or refused. What each is worth in accuracy is shown in convergence/start_test.
#include <gtest/gtest.h>

#include <algorithm>

#include "polynomial.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"

namespace tandem {
namespace {

using test::refuses;
using test::RunBench;
using test::Scripted;

/// Gives 0 with so many derivatives, all 0.
Scripted zero(int derivatives, bool restarts) {
  const SubsystemInfo info{"zero", {{"u", "1"}}, {{"y", "1", 1, derivatives}}, {}, {.restarts = restarts}};
  return {info, 0.5, [derivatives](double, const auto&, double* y) { std::fill_n(y, 1 + derivatives, 0.0); }};
}
RunBench couple(Scripted& a, Scripted& b, StartKind start, const std::string& how = "lagrange3") {
  RunBench bench;
  bench.add("a", a).add("b", b).connect("a.y", "b.u", how).connect("b.y", "a.u", how);
  bench.coordination.order = {"a", "b"};
  bench.coordination.start = start;
  return bench;
}

TEST(Start, IsFromDerivativesWhereThereAreEnoughElseRepeatedElseColdWithANote) {
  Scripted a = zero(2, true), b = zero(2, true);
  couple(a, b, StartKind::automatic).run(4.0);
  EXPECT_EQ(a.starts.size(), 2U) << "NaN first, then with b's output";
  Scripted c = zero(1, true), d = zero(2, true);
  RunBench repeated = couple(c, d, StartKind::automatic);
  repeated.run(4.0);
  EXPECT_GT(c.starts.size(), 2U);
  EXPECT_TRUE(repeated.coordinator->notes().empty());
  Scripted e = zero(1, false), f = zero(2, true);
  RunBench cold = couple(e, f, StartKind::automatic);
  cold.run(4.0);
  EXPECT_EQ(e.starts.size(), 2U);
  ASSERT_EQ(cold.coordinator->notes().size(), 1U);
  EXPECT_EQ(
      cold.coordinator->notes()[0].find("cold start: output a.y gives 1 derivatives, and lagrange3 needs 2 "
                                        "of it; subsystem 'a' can't restart; the order stays at 2"),
      0U)
      << cold.coordinator->notes()[0];
}

TEST(Start, ThatIsAskedForAndCanNotBeMadeIsRefused) {
  Scripted a = zero(1, false), b = zero(2, true);
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"derivatives", "a.y gives 1"},
                      [&] { couple(a, b, StartKind::derivatives).run(4.0); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"repeated start", "'a' can't restart"},
                      [&] { couple(a, b, StartKind::repeat).run(4.0); }));
  EXPECT_NO_THROW(couple(a, b, StartKind::cold).run(4.0));
}

TEST(Start, NeedsNothingUpToDegreeOne) {
  Scripted a = zero(0, false), b = zero(0, false);
  RunBench bench = couple(a, b, StartKind::automatic, "lagrange1");
  bench.run(4.0);
  EXPECT_TRUE(bench.coordinator->notes().empty());
}

TEST(Start, RepeatedTellsItsSamplesOnceAndGoesOnFromThem) {
  Scripted a = zero(0, true), b = zero(0, true);
  RunBench bench = couple(a, b, StartKind::repeat);
  bench.run(4.0);
  ASSERT_EQ(bench.recording.rows(0).size(), 9U);
  for (std::size_t row = 0; row < 9; ++row)
    EXPECT_EQ(bench.recording.time(0, row), 0.5 * static_cast<double>(row));
}

TEST(Start, RepeatedReadsACubicExactlyFromTheFirstStepOn) {
  const test::Polynomial cubic = test::Polynomial::of_degree(3);
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    Scripted source({"cubic", {}, {{"y", "1"}}, {}, {.restarts = true}}, 0.5,
                    [&](double t, const auto&, double* y) { y[0] = cubic(t); });
    SubsystemInfo info = test::mirror(0.2).info();
    info.abilities.restarts = true;
    Scripted reader(info, 0.2, [](double, const auto& u, double* y) { y[0] = u[0]; });
    RunBench bench;
    bench.add("source", source).add("reader", reader).schedule(schedule);
    bench.connect("source.y", "reader.u", "lagrange3").run(6.0);
    ASSERT_EQ(bench.recording.rows(1).size(), 31U);
    for (std::size_t row = 0; row < 31; ++row)  // values below 500, Lebesgue functions below 100: 40 eps 5e4
      EXPECT_NEAR(bench.recording.value(1, row), cubic(bench.recording.time(1, row)), 5e-10) << schedule;
  }
}

TEST(Start, RepeatedMayReachTheEnd) {
  Scripted a = zero(0, true), b = zero(0, true);
  RunBench bench = couple(a, b, StartKind::repeat);
  bench.run(1.2);
  EXPECT_EQ(bench.recording.rows(0).size(), 3U);
  EXPECT_EQ(bench.coordinator->time(1), 1.0);
}

}  // namespace
}  // namespace tandem
