// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/experiment.hpp"

#include <gtest/gtest.h>

#include "engine_linkage/linkage.hpp"
#include "engine_linkage/sweep.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::engine_linkage {
namespace {

const std::filesystem::path folder = TANDEM_SOURCE_DIR "/scenarios/engine_linkage";

TEST(EngineLinkageExperiment, OneLoopIsTheMechanismOfTheScenario) {
  mbs::Mechanism written(mbs::read_mechanism("linkage", linkage_text(1))),
      file(mbs::read_mechanism(folder / "linkage.toml"));
  EXPECT_EQ(written.structure().variable_names, file.structure().variable_names);
  EXPECT_EQ(written.structure().constraint_names, file.structure().constraint_names);
  EXPECT_EQ(written.structure().mass.values, file.structure().mass.values);
  EXPECT_EQ(written.described_state().q, file.described_state().q);
  EXPECT_EQ(written.described_state().v, file.described_state().v);
}

/// The goal of the scene: within 0.05 rad/s with ten steps of the engine in one of the linkage, for 30 s.
/// Each of these passes some 180 flat positions with a torque that jumps. Two calls for each step of the
/// linkage; the first few steps are those of the start.
TEST(EngineLinkageExperiment, StaysNearTheTruthAtAStepRatioOfTen) {
  const auto engine = engine::read_diagram(folder / "engine.toml");
  const Truth truth(engine, 1, t_stop);
  for (const Scheme& scheme :
       {Scheme{"slowest-first", "hermite", "lagrange0"}, Scheme{"fastest-first", "hermite", "mean"},
        Scheme{"parallel", "lagrange0", "lagrange0"}}) {
    const Outcome o = run_case({scheme, 1, 1e-4, 10.0}, engine, truth);
    EXPECT_TRUE(o.stable) << o.note;
    EXPECT_LT(o.largest, 0.05) << scheme.schedule;
    EXPECT_LE(o.rms, o.largest);
    EXPECT_GE(o.exchanges, 60000 - 10);
  }
}

TEST(EngineLinkageSweep, WritesWhatItIsAsked) {
  EXPECT_EQ(sweep_cases().size(), 6 * equal_step_cases().size());
  const Case c{{"parallel", "lagrange0", "mean"}, 2, 1e-4, 5.0};
  EXPECT_EQ(scheme_row(c, {.largest = 0.25, .rms = 0.125, .exchanges = 7}),
            "2,parallel,lagrange0,mean,5,2.5000e-01,1.2500e-01,7,stable");
  EXPECT_EQ(scheme_row(c, {.exchanges = 7, .stable = false}), "2,parallel,lagrange0,mean,5,,,7,unstable");
}

/// 0.3 s by the scheme of the scene.
TEST(EngineLinkageSweep, SplitsTheTimeOfARun) {
  const auto engine = engine::read_diagram(folder / "engine.toml");
  const Elapsed e = time_case(size_cases()[2], engine, 0.3);
  EXPECT_GT(e.engine, 0.0);
  EXPECT_GT(e.linkage, 0.0);
  EXPECT_GE(e.total, e.engine + e.linkage);
  EXPECT_GE(e.exchanges, 600 - 10);
}

}  // namespace
}  // namespace tandem::engine_linkage
