// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "c_models.h"
#include "c_oscillator.h"
#include "contract_suite.hpp"
#include "diagram_cases.hpp"
#include "mechanism_cases.hpp"
#include "pendulum_subsystem.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "two_mass/masses.hpp"

namespace tandem::test {
namespace {

ContractCase builtin(const std::string& name, const std::string& parameters = "", double t_start = 0.0) {
  return {name + parameters,
          [name, parameters] {
            Builtins builtins;
            two_mass::add_builtins(builtins);
            return open("builtin:" + name + parameters, builtins);
          },
          t_start};
}

INSTANTIATE_TEST_SUITE_P(TwoMass, SubsystemContract,
                         testing::Values(builtin("two_mass.fast"), builtin("two_mass.slow"),
                                         builtin("two_mass.both"), builtin("two_mass.fast_force"),
                                         builtin("two_mass.slow_force"),
                                         builtin("two_mass.fast_force", "?carried_mass=0.5"),
                                         builtin("two_mass.slow_force", "?carried_mass=0.5"),
                                         builtin("two_mass.slow", "?reuse_acceleration=true"),
                                         builtin("two_mass.fast", "?frequency_ratio=30.7&phase1=0.8", -7.3),
                                         builtin("two_mass.slow", "?frequency_ratio=30.7&phase1=0.8", 1e4)),
                         contract_name);

ContractCase in_c(const std::string& parameters, double t_start = 0.0) {
  return {"oscillator " + parameters,
          [parameters] { return std::make_unique<CSubsystem>(c_oscillator(), parameters); }, t_start};
}

INSTANTIATE_TEST_SUITE_P(InC, SubsystemContract,
                         testing::Values(in_c(""), in_c("m=2&k=30&c=0.1&h=0.013"),
                                         in_c("h=0.03&x0=1&v0=-2", -7.3)),
                         contract_name);

ContractCase model_in_c(const char* name, const tandem_subsystem_api* api, const std::string& parameters,
                        double t_start = 0.0) {
  return {name, [=] { return std::make_unique<CSubsystem>(api, parameters); }, t_start};
}

INSTANTIATE_TEST_SUITE_P(ModelInC, SubsystemContract,
                         testing::Values(model_in_c("integral", c_integral(), ""),
                                         model_in_c("integral later", c_integral(), "h=0.03", 1e4),
                                         model_in_c("switch", c_switch(), "h=0.013", -7.3)),
                         contract_name);

INSTANTIATE_TEST_SUITE_P(Mechanism, SubsystemContract, testing::ValuesIn(mechanism_cases()), contract_name);
INSTANTIATE_TEST_SUITE_P(Diagram, SubsystemContract, testing::ValuesIn(diagram_cases()), contract_name);

INSTANTIATE_TEST_SUITE_P(HandWrittenModel, SubsystemContract,
                         testing::Values(ContractCase{
                             "pendulum", [] { return std::make_unique<example::PendulumSubsystem>(0.01); }}),
                         contract_name);

std::unique_ptr<Subsystem> named_model() {
  mbs::NamedModel model{
      "pendulum", std::make_shared<example::Pendulum>(), example::Pendulum::level(0.0), {"m", "m"}};
  return mbs::make_subsystem(std::move(model), {.step = 0.01, .stepper = {.formulation = "index3"}});
}
INSTANTIATE_TEST_SUITE_P(NamedModel, SubsystemContract,
                         testing::Values(ContractCase{"pendulum", named_model}), contract_name);

/// x'' = -x from x = 1: x = cos t. The method's error is below t h^4 / 100.
TEST(COscillator, FollowsItsExactMotion) {
  CSubsystem subsystem(c_oscillator(), "x0=1&h=0.01&k=1");
  const std::vector<double> zero = {0.0};
  std::vector<double> memory(11 * 1001);
  Samples y(memory.data(), 11, 1001);
  subsystem.initialize(0.0, 10.0, zero, y);
  const Segment none{0.0, 0.0, {}};
  const Signal u(&none, 1, 0);
  subsystem.advance(10.0, false, {&u, 1}, y);
  ASSERT_EQ(y.size(), 1001);
  for (std::int64_t k = 1; k < y.size(); ++k) {
    EXPECT_NEAR(y.values(k)[0], std::cos(y.time(k)), 10.0 * 1e-8 / 100.0);
    EXPECT_EQ(y.values(k)[1], y.values(k)[3]) << "v is the derivative of x";
    EXPECT_EQ(y.values(k)[2], y.values(k)[6]) << "a is its second derivative";
  }
}

}  // namespace
}  // namespace tandem::test
