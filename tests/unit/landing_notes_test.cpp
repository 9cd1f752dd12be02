// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a run notes of those that end own steps at the samples of others, or do not.
#include <gtest/gtest.h>

#include "linear_controller.hpp"
#include "run_bench.hpp"

namespace tandem::test {
namespace {

/// A lag with an own step of 0.1 s and a controller beside it, each reads the other.
class LandingNotes : public testing::Test {
 protected:
  explicit LandingNotes(double period = 0.25) : control_(controller(period)) {}

  static Linear scalar(double a, double b) {
    const auto one = [](double value) { return MatrixXd::Constant(1, 1, value); };
    return {one(a), one(b), one(1.0), one(0.0), VectorXd::Constant(1, 1.0)};
  }
  static std::unique_ptr<Subsystem> controller(double period) {
    return std::make_unique<Sampled<LinearController>>(LinearController(scalar(0.5, 0.1), {period}));
  }

  std::string notes(double period, Landing landing, Subsystem* plant = nullptr) {
    control_ = controller(period);
    RunBench bench;
    bench.add("plant", plant ? *plant : plant_).add("control", *control_);
    bench.connect("plant.y", "control.u", "lagrange1").connect("control.y", "plant.u", "");
    bench.coordination.landing["plant"] = landing;
    bench.coordination.start = StartKind::cold;
    bench.run(2.0);
    std::string all;
    for (const std::string& note : bench.coordinator->notes()) all += note + "\n";
    return all;
  }

  FixedStep<LinearModel> plant_{LinearModel(scalar(-1.0, 1.0), 0.1, Method::rk4)};
  std::unique_ptr<Subsystem> control_;
};

TEST_F(LandingNotes, TellHowManyOwnStepsItCosts) {
  // 20 own steps, and samples at 0.25, 0.75, 1.25 and 1.75 s beside them.
  EXPECT_EQ(notes(0.25, Landing::automatic),
            "subsystem 'plant' took 24 own steps where 20 fit, as it ended some at samples of others\n");
  EXPECT_EQ(notes(0.5, Landing::automatic), "") << "all samples are own nodes";
}

TEST_F(LandingNotes, TellWhoStepsOverSamplesAndWhy) {
  const std::string who = "subsystem 'plant' does not end own steps at the samples of 'control', as ",
                    so = "; where it does not split them there itself, it errs to first order\n";
  EXPECT_EQ(notes(0.25, Landing::never), who + "land = \"never\" says so" + so);
  EXPECT_EQ(notes(0.03, Landing::automatic), who + "they come more often than its own steps" + so);
}

TEST_F(LandingNotes, TellOfAPeriodBeyondTheSpan) {
  EXPECT_NE(
      notes(3.0, Landing::automatic)
          .find("subsystem 'control' is sampled every 3 s, longer than the span, 2 s: it acts at most once"),
      std::string::npos);
}

TEST_F(LandingNotes, TellWhereStepsAreMoreThanDoubled) {
  EXPECT_EQ(notes(0.03, Landing::always).find("subsystem 'plant' takes up to 4.3 times its own steps, as it"),
            0U)
      << notes(0.03, Landing::always);
  EXPECT_EQ(notes(0.11, Landing::automatic).find("times its own steps"), std::string::npos);
}

TEST_F(LandingNotes, TellOfASampledOneThatIsToLand) {
  RunBench bench;
  bench.add("plant", plant_).add("control", *control_);
  bench.connect("plant.y", "control.u", "lagrange1").connect("control.y", "plant.u", "");
  bench.coordination.landing["control"] = Landing::always;
  bench.run(2.0);
  EXPECT_EQ(
      bench.coordinator->notes().at(0).find("land has no effect for subsystem 'control', which is sampled"),
      0U);
}

/// The controller reads samples of the plant alone, whatever the degree.
TEST_F(LandingNotes, TellOfNoColdStartWhereOnlySamplesAreRead) {
  for (const bool lands : {true, false}) {
    RunBench bench;
    bench.add("plant", plant_).add("control", *control_);
    bench.connect("plant.y", "control.u", "lagrange4").connect("control.y", "plant.u", "");
    bench.coordination.landing["plant"] = lands ? Landing::automatic : Landing::never;
    bench.run(2.0);
    std::string all;
    for (const std::string& note : bench.coordinator->notes()) all += note;
    EXPECT_EQ(all.find("cold start: output plant.y gives ") != std::string::npos, !lands) << all;
  }
}

}  // namespace
}  // namespace tandem::test
