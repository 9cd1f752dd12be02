// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/make_stepper.hpp"

#include <gtest/gtest.h>

#include "driven_pendulum.hpp"
#include "refusal.hpp"

namespace tandem::mbs {
namespace {

testing::AssertionResult settings_refused(const StepperSettings& settings,
                                          const std::vector<std::string>& says) {
  test::DrivenPendulum pendulum({});
  return test::refuses(ErrorCode::invalid_argument, says, [&] { make_stepper(pendulum, settings); });
}

StepperSettings chosen(const std::string& formulation, const std::string& integrator = "newmark") {
  StepperSettings settings;
  settings.formulation = formulation;
  settings.integrator = integrator;
  return settings;
}

TEST(MakeStepper, RefusesNamesThatAreNotThere) {
  EXPECT_TRUE(settings_refused(chosen("index2"), {"formulation 'index2'", "index1", "null_space"}));
  EXPECT_TRUE(
      settings_refused(chosen("penalty", "newmrak"), {"integrator 'newmrak'", "did you mean 'newmark'?"}));
}

TEST(MakeStepper, RefusesOtherIntegratorsForTheMergedFormulation) {
  for (const char* integrator : {"rk2", "rk4", "generalized_alpha"})
    EXPECT_TRUE(settings_refused(chosen("index3", integrator), {"index3", "does not go with integrator",
                                                                integrator, "allowed is newmark"}));
}

TEST(MakeStepper, RefusesSettingsOfWhatIsNotChosen) {
  StepperSettings settings = chosen("index1", "rk4");
  settings.penalty.omega = 5.0;
  EXPECT_TRUE(settings_refused(settings, {"settings of penalty", "not chosen"}));
  settings = chosen("index1", "rk4");
  settings.newmark.beta = 0.2;
  EXPECT_TRUE(settings_refused(settings, {"settings of newmark", "not chosen"}));
  settings = chosen("index3");
  settings.newmark.beta = 0.2;
  EXPECT_TRUE(settings_refused(settings, {"settings of newmark", "index3.beta"}));
}

TEST(MakeStepper, RefusesSettingsThatAreNotAllowed) {
  StepperSettings settings = chosen("penalty");
  settings.penalty.penalty = -1.0;
  EXPECT_TRUE(settings_refused(settings, {"penalty formulation", "penalty is -1"}));
  settings.penalty = {.xi = -0.5};
  EXPECT_TRUE(settings_refused(settings, {"xi is -0.5"}));
  settings.penalty = {.omega = -2.0};
  EXPECT_TRUE(settings_refused(settings, {"omega is -2"}));
  settings.penalty = {.solver = "kul"};
  EXPECT_TRUE(settings_refused(settings, {"'kul'"}));
  settings = chosen("index1");
  settings.index1.multiplier_iterations = 0;
  EXPECT_TRUE(settings_refused(settings, {"index-1 formulation", "multiplier_iterations is 0"}));
  settings = chosen("null_space");
  settings.null_space.tolerance = -1.0;
  EXPECT_TRUE(settings_refused(settings, {"null-space formulation", "tolerance is -1"}));
  settings = chosen("index1");
  settings.newmark.beta = 0.3;
  EXPECT_TRUE(settings_refused(settings, {"Newmark", "beta is 0.3", "1/12 to 1/4"}));
  settings = chosen("index1", "generalized_alpha");
  settings.generalized_alpha.spectral_radius = 1.5;
  EXPECT_TRUE(settings_refused(settings, {"spectral_radius is 1.5", "0 to 1"}));
}

}  // namespace
}  // namespace tandem::mbs
