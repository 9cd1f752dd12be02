// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "scratch.hpp"
#include "scripted.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/sampled.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

using test::Scratch;
using test::Scripted;
using text::TimeTable;

/// Gives how often it has acted.
struct Counter {
  SubsystemInfo info() const { return {"counter", {}, {{"n", "1"}}, {}, {}}; }
  double own_step() const { return 0.25; }
  double offset() const { return 0.2; }
  void start(double, std::span<const double>) { n_ = 0.0; }
  void outputs(double* y) const { *y = n_; }
  void step(const OwnStep&, std::span<const Signal>) { n_ += 1.0; }
  double n_ = 0.0;
};

TEST(RecorderOfHeldOutputs, MakesThemStepsThatHoldToTheEnd) {
  Scripted other({"line", {}, {{"l", "N"}}, {}, {}}, 0.1,
                 [](double t, const std::vector<double>&, double* y) { *y = 3.0 - 7.0 * t; });
  Sampled<Counter> counter{Counter{}};
  Topology topology;
  topology.add("other", other.info());
  topology.add("counter", counter.info());
  Coordinator run(topology, {&other, &counter}, {}, TimeSpan{0.0, 2.0});
  const Scratch folder;
  Recorder recorder(run, {.directory = folder.path(), .clock = "", .ports = {"counter.n", "other.l"}});
  run.observe(&recorder);
  run.run();
  recorder.close();
  EXPECT_TRUE(recorder.notes().empty());
  EXPECT_EQ(Recorder::name(recorder.columns()[1].fill), "held");
  const TimeTable table = TimeTable::read(folder.path() / "results.csv");
  ASSERT_EQ(table.times.size(), 21U) << "those of the one that integrates itself";
  for (std::size_t row = 0; row < 21; ++row) {
    const double t = table.times[row], acted = std::floor((t - 0.2) / 0.25 + 1e-9) + 1.0;
    EXPECT_EQ(table.columns[1][row], std::max(acted - 1.0, 0.0)) << t;
  }
}

}  // namespace
}  // namespace tandem
