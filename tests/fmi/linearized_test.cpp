// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Equations of FMUs by their directional derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "command.hpp"
#include "fmus.hpp"

namespace tandem::test {
namespace {

std::optional<Linearized> linearized(const std::string& name, std::vector<double> u0 = {}) {
  const auto fmu = open_fmu(name);
  std::vector<double> row(static_cast<std::size_t>(fmu->info().row_size()));
  Samples y(row.data(), fmu->info().row_size(), 1);
  fmu->initialize(0.0, 1.0, u0, y);
  return fmu->linearized();
}

/// x' = v, v' = mu (1 - x^2) v - x about (2, 0).
TEST(FmuEquations, OfVanDerPolAreThoseOfItsStart) {
  for (const double mu : {1.0, 2.5}) {
    const auto found = linearized("van_der_pol?type=me&set.mu=" + std::to_string(mu));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->a, (std::vector<double>{0, 1, -1, -3 * mu}));
    EXPECT_EQ(found->c, (std::vector<double>{1, 0, 0, 1}));
    EXPECT_TRUE(found->b.empty() && found->d.empty());
  }
}

/// m x'' = k (u - x) - s x - d x', F = k (u - x).
TEST(FmuEquations, OfAMassHaveItsInputsOfBothVersions) {
  for (const std::string name : {"mass", "mass3"}) {
    const auto fmu = open_fmu(name + "?type=me&set.m=2&set.k=3&set.s=5&set.d=0.5");
    const int inputs = fmu->info().input_size(), outputs = fmu->info().output_size();
    const auto found =
        linearized(name + "?type=me&set.m=2&set.k=3&set.s=5&set.d=0.5", std::vector<double>(inputs, 0.3));
    ASSERT_TRUE(found) << name;
    const double a[] = {0, 1, -4, -0.25};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found->a[k], a[k], 1e-14) << name;
    const auto in = static_cast<std::size_t>(inputs);
    EXPECT_EQ(found->b[0], 0.0);
    EXPECT_NEAR(found->b[in], 1.5, 1e-14) << name;
    int k = 0;
    while (scalar_at(fmu->info().outputs, k).name() != "F") ++k;
    const auto row = static_cast<std::size_t>(k);
    EXPECT_LT(k, outputs);
    EXPECT_NEAR(found->c[2 * row], -3.0, 1e-14);
    EXPECT_EQ(found->c[2 * row + 1], 0.0);
    EXPECT_NEAR(found->d[in * row], 3.0, 1e-14);
  }
}

/// x1'' = (x2 - x1) - x1 and 2 x2'' = 3 (x1 - x2) - x2: frequencies sqrt((4 -+ sqrt 6) / 2) / 2 pi.
TEST(FmuEquations, GiveTheModesOfCoupledFmus) {
  const Scratch folder;
  const std::string fmu = "\nsource = 'fmu:" TANDEM_FMUS "/mass";
  folder.write("s.toml",
               "[subsystems.one]" + fmu + ".fmu?type=me&step=0.01'\n[subsystems.two]" + fmu +
                   "3.fmu?type=me&step=0.02&set.m=2&set.k=3'\n[[connections]]\nfrom = 'one.x'\nto = 'two.u'\n"
                   "reconstruction = 'lagrange3'\n[[connections]]\nfrom = 'two.x'\nto = 'one.u'\n"
                   "reconstruction = 'lagrange3'\n[span]\nstop = 10\n");
  const Said said = tandem(folder, {"stability", "s.toml"});
  ASSERT_EQ(said.status, 0) << said.err;
  for (const double sign : {-1.0, 1.0}) {
    const double f = std::sqrt((4.0 + sign * std::sqrt(6.0)) / 2.0) / (2.0 * std::numbers::pi);
    EXPECT_TRUE(contains(said.out, std::to_string(f))) << f << said.out;
  }
}

TEST(FmuEquations, AreUnknownWhereTheFmuGivesNone) {
  EXPECT_FALSE(linearized("decay?type=me"));
  EXPECT_FALSE(linearized("mass?type=cs&inputs=mean", {0.3}));
}

}  // namespace
}  // namespace tandem::test
