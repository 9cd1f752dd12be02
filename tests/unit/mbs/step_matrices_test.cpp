// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/step_matrices.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/matrix_file.hpp"

namespace tandem::mbs {
namespace {

const std::string sprung =
    "dimension = 2\ngravity = [0, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\nA = { at = [1, 0] }\n"
    "B = { at = [2, 0.5] }\n[rods]\nr = { points = ['O', 'A'], mass = 1 }\ns = { points = ['A', 'B'], mass = "
    "2 }\n"
    "[springs]\nk = { points = ['O', 'B'], stiffness = 30, damping = 2, free = 1.5 }\n";

Eigen::MatrixXd dense(const Matrix& a) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(a.pattern.rows(), a.pattern.columns());
  const auto entries = a.pattern.entries();
  for (std::size_t k = 0; k < entries.size(); ++k) full(entries[k].first, entries[k].second) = a.values[k];
  return full;
}

/// T at a state with v = 0, as its matrices say.
TEST(StepMatrices, TheTangentIsTheSumOfTheOthers) {
  Mechanism m(read_mechanism("sprung", sprung));
  const auto a = step_matrices(m, m.described_state(), {0.1, 0.2, 0.3});
  ASSERT_EQ(a.jacobian.pattern.rows(), 2);
  ASSERT_EQ(a.jacobian.pattern.columns(), 4);
  EXPECT_EQ(dense(a.jacobian)(0, 0), 2.0);  // (|A|^2 - l^2) / l by A.x
  const Eigen::MatrixXd j = dense(a.jacobian);
  const Eigen::MatrixXd sum =
      dense(a.mass) + 0.1 * dense(a.damping) + 0.2 * dense(a.stiffness) + 0.3 * j.transpose() * j;
  EXPECT_LT((dense(a.tangent) - sum).norm(), 1e-14 * sum.norm());
}

/// Against the assembly that steps use, by a solver that gets all of it.
TEST(StepMatrices, TheTangentIsTheOneThatIsFactorized) {
  Mechanism m(read_mechanism("sprung", sprung));
  for (const auto& [formulation, integrator] : stepper_names()) {
    const auto stepper = make_stepper(m, {formulation, integrator});
    const TangentFactors factors = stepper->tangent_factors(1e-3);
    if (formulation == "null_space") {
      EXPECT_EQ(factors.penalty, 0.0);
      continue;
    }
    const State s = m.described_state();
    ModelMatrices at(m.structure());
    Eigen::VectorXd phi(2), b = Eigen::VectorXd::LinSpaced(4, -1.0, 1.0), x = b;
    m.constraints(s.q.data(), phi.data(), at.jacobian.data());
    m.force_derivatives(s.q.data(), s.v.data(), at.stiffness.data(), at.damping.data());
    Tangent tangent(m.structure(), make_solver("eigen_dense", MatrixKind::positive_definite));
    tangent.assemble(at, factors);
    ASSERT_EQ(tangent.factorize(), -1);
    tangent.solve(x.data());
    const Eigen::MatrixXd t = dense(step_matrices(m, s, factors).tangent);
    EXPECT_LT((t * x - b).norm(), 1e-14 * t.norm() * x.norm()) << formulation;
  }
}

TEST(StepMatrices, AreWrittenWithALabel) {
  const test::Scratch folder;
  Mechanism m(read_mechanism("sprung", sprung));
  const auto a = step_matrices(m, m.described_state(), {0.0, 0.0, 1.0});
  write(a, folder.path() / "new", "0.5", MatrixFormat::matrix_market);
  write(a, folder.path() / "new", "0.5", matrix_format("ccs"));
  EXPECT_EQ(read_matrix_market(folder.path() / "new" / "tangent_0.5.mtx").values, a.tangent.values);
  EXPECT_EQ(read_compressed_columns(folder.path() / "new" / "jacobian_0.5.ccs").values, a.jacobian.values);
  EXPECT_TRUE(
      test::refuses(ErrorCode::invalid_argument, {"'csv'", "mtx", "ccs"}, [] { matrix_format("csv"); }));
  const auto file = folder.write("file", "");
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"file", "can't be made"},
                            [&] { write(a, file / "new", "0", MatrixFormat::matrix_market); }));
}

}  // namespace
}  // namespace tandem::mbs
