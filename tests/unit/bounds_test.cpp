// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "run_bench.hpp"
#include "scripted.hpp"

namespace tandem {
namespace {

/// y = first exp(40 t / s), whose own step is 0.01 s, beside one that reads it.
struct Growing {
  explicit Growing(double first, double nominal = 1.0) {
    SubsystemInfo info = grows.info();
    info.outputs[0].nominal = nominal;
    grows = {info, 0.01, [first](double t, const auto&, double* y) { y[0] = first * std::exp(40.0 * t); }};
    bench.add("grows", grows).add("reads", reads).connect("grows.y", "reads.u", "lagrange1");
  }
  /// The sentence that a run of 1 s ends with; "" if it comes to its end.
  std::string ends() try {
    bench.run(1.0);
    return "";
  } catch (const Diverged& error) {
    return error.what();
  }
  double last_told() const { return bench.recording.rows(0).back()[0]; }

  test::Scripted grows = test::source(0.01, [](double) { return 0.0; }), reads = test::listener(0.1);
  test::RunBench bench;
};

/// 2 exp(0.4) = 2.98 is seen in the first hundredth; 1e8 times as much at t = 0.4705 s.
TEST(Bounds, EndARunAtTheFirstSampleThatIsBeyondThem) {
  Growing run(2.0);
  const std::string sentence = run.ends();
  for (const char* part :
       {"'grows' diverged", "gave y = 435997549.35", "at t = 0.48 s", "up to 298364939.5", "1e+08 ("})
    EXPECT_NE(sentence.find(part), std::string::npos) << part << " in: " << sentence;
  EXPECT_NEAR(run.last_told(), 0.47, 1e-15);
}

/// 1e-6 exp(40 t) is 1e8 at t = 0.806 s, and 100 times as much at 0.921 s.
TEST(Bounds, AreOfTheNominalValueAndOfOneWhereThatIsMore) {
  Growing plain(1e-6), nominal(1e-6, 100.0);
  EXPECT_NE(plain.ends().find("at t = 0.81 s"), std::string::npos);
  EXPECT_NE(nominal.ends().find("at t = 0.93 s"), std::string::npos);
}

TEST(Bounds, AreLiftedByInfinity) {
  Growing run(2.0);
  run.bench.coordination.diverged_beyond = std::numeric_limits<double>::infinity();
  EXPECT_EQ(run.ends(), "");
}

TEST(Bounds, AreLearnedForAHundredthOfTheSpanWhereverItStarts) {
  test::Scripted grows = test::source(0.01, [](double t) { return std::exp(40.0 * (t + 3.0)); }),
                 reads = test::listener(0.1);
  test::RunBench bench;
  bench.add("grows", grows).add("reads", reads).connect("grows.y", "reads.u", "lagrange1");
  EXPECT_THROW(bench.run(-2.0, -3.0), Diverged);
  EXPECT_NEAR(bench.recording.rows(0).back()[0], -3.0 + 0.47, 1e-12);
}

SubsystemInfo with_derivative() { return {"s", {}, {{"y", "m", 1, 1}}, {}, {}}; }

TEST(Bounds, OfDerivativesAreThoseOfNumbers) {
  const SubsystemInfo info = with_derivative();
  Bounds bounds(info);
  bounds.watch(1.0, 10.0);
  const double small[] = {3.0, 0.0}, steep[] = {29.0, 1e300}, high[] = {31.0, 0.0},
               no_number[] = {1.0, std::nan("")};
  EXPECT_FALSE(bounds.pass(small)) << "it is to be learned of";
  bounds.check("s", 1.0, small);
  bounds.check("s", 1.1, steep);
  EXPECT_TRUE(bounds.pass(steep));
  EXPECT_FALSE(bounds.pass(high));
  EXPECT_FALSE(bounds.pass(no_number));
  EXPECT_THROW(bounds.check("s", 1.2, high), Diverged);
}

TEST(Bounds, GoOnFromACheckpoint) {
  const SubsystemInfo info = with_derivative();
  Bounds first(info), second(info);
  for (Bounds* bounds : {&first, &second}) bounds->watch(1.0, 10.0);
  const double seen[] = {3.0, 0.0}, within[] = {29.0, 0.0}, beyond[] = {31.0, 0.0};
  first.check("s", 0.5, seen);
  ByteWriter bytes;
  first.write(bytes);
  ByteReader from(bytes.bytes(), "bounds");
  second.read(from);
  from.end();
  second.check("s", 2.0, within);
  EXPECT_THROW(second.check("s", 2.1, beyond), Diverged);
}

TEST(Bounds, ThatAreNoneAreRefused) {
  const SubsystemInfo info = with_derivative();
  for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    ByteWriter bytes;
    bytes.put(std::uint8_t{0});
    bytes.put_list(std::vector<double>{1.0, wrong});
    ByteReader from(bytes.bytes(), "bounds");
    Bounds bounds(info);
    EXPECT_THROW(bounds.read(from), Error) << wrong;
  }
}

}  // namespace
}  // namespace tandem
