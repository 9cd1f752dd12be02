// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Every stepper against IDA of SUNDIALS, which shares no code with any of them but the model's own terms.
#if TANDEM_SUNDIALS
#include <gtest/gtest.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>

#include "driven_pendulum.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {
namespace {

using Eigen::Map;
using Eigen::VectorXd;

/// The equations in the form of index 1, unknowns (q, q', lambda):
///   (q)' - v = 0,  M v' + Phi_q^T lambda - Q = 0,  Phi_q v' + gamma = 0.
struct Problem {
  Model& model;
  State at;  ///< for the coordinates that stay fixed

  static int residual(double t, N_Vector y, N_Vector rate, N_Vector result, void* self) {
    static_cast<Problem*>(self)->evaluate(t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate),
                                          N_VGetArrayPointer(result));
    return 0;
  }

  void evaluate(double t, const double* y, const double* rate, double* result) {
    const Structure& s = model.structure();
    const int n = s.variables, m = s.constraints;
    VectorXd phi(m), gamma(m), jacobian(s.jacobian_values()), inertia(n), held(n), force(n);
    at.q.head(n) = Map<const VectorXd>(y, n);
    at.v.head(n) = Map<const VectorXd>(y + n, n);
    model.at_time(t);
    model.constraints(at.q.data(), phi.data(), jacobian.data());
    model.constraint_accelerations(at.q.data(), at.v.data(), gamma.data());
    model.forces(at.q.data(), at.v.data(), force.data());
    multiply_symmetric(s.mass, rate + n, inertia.data());
    Rows(s.jacobian).multiply(jacobian.data(), y + 2 * n, held.data());
    Map<VectorXd>(result, n) = Map<const VectorXd>(rate, n) - at.v.head(n);
    Map<VectorXd>(result + n, n) = inertia + held - force;
    multiply_transposed(s.jacobian, jacobian.data(), rate + n, result + 2 * n);
    Map<VectorXd>(result + 2 * n, m) += gamma;
  }
};

/// By IDA with relative tolerance 1e-10: good to some 1e-8. It starts from what null_space completes, as it
/// takes no step from multipliers that are off by a penalty's rounding.
State by_ida(Model& model, State first, double end) {
  NullSpace(model, {}).start(first);
  const int n = model.structure().variables, m = model.structure().constraints, size = 2 * n + m;
  Problem problem{model, first};
  SUNContext context;
  EXPECT_EQ(SUNContext_Create(nullptr, &context), 0);
  N_Vector y = N_VNew_Serial(size, context), rate = N_VNew_Serial(size, context);
  Map<VectorXd> unknowns(N_VGetArrayPointer(y), size), rates(N_VGetArrayPointer(rate), size);
  unknowns << first.q.head(n), first.v.head(n), first.lambda;
  rates << first.v.head(n), first.a.head(n), VectorXd::Zero(m);
  void* ida = IDACreate(context);
  SUNMatrix matrix = SUNDenseMatrix(size, size, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  double reached = 0.0;
  EXPECT_EQ(IDAInit(ida, Problem::residual, first.time, y, rate), IDA_SUCCESS);
  EXPECT_EQ(IDASStolerances(ida, 1e-10, 1e-11), IDA_SUCCESS);
  EXPECT_EQ(IDASetUserData(ida, &problem), IDA_SUCCESS);
  EXPECT_EQ(IDASetLinearSolver(ida, solver, matrix), IDA_SUCCESS);
  N_Vector differential = N_VNew_Serial(size, context);  // lambda is not
  Map<VectorXd>(N_VGetArrayPointer(differential), size) << VectorXd::Ones(2 * n), VectorXd::Zero(m);
  EXPECT_EQ(IDASetId(ida, differential), IDA_SUCCESS);
  EXPECT_EQ(IDASetSuppressAlg(ida, SUNTRUE), IDA_SUCCESS);
  EXPECT_EQ(IDASetMaxNumSteps(ida, 100'000), IDA_SUCCESS);
  EXPECT_EQ(IDASolve(ida, end, &reached, y, rate, IDA_NORMAL), IDA_SUCCESS);
  State s = first;
  s.time = reached;
  s.q.head(n) = unknowns.head(n);
  s.v.head(n) = unknowns.segment(n, n);
  s.a.head(n) = rates.segment(n, n);
  s.lambda = unknowns.tail(m);
  IDAFree(&ida);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(differential);
  N_VDestroy(y);
  N_VDestroy(rate);
  SUNContext_Free(&context);
  return s;
}

class EachStepperAndIda : public testing::TestWithParam<StepperNames> {
 protected:
  std::unique_ptr<Stepper> make(Model& model) const {
    StepperSettings settings;
    settings.formulation = GetParam().formulation;
    settings.integrator = GetParam().integrator;
    if (settings.formulation == "index3") settings.index3 = {.tolerance = 1e-12};
    return make_stepper(model, settings);
  }
  /// Errors fall to a quarter at least when the step is halved, down to IDA's own.
  void expect_agreement(Model& model, State s, double end) const {
    const State expected = by_ida(model, s, end);
    const auto run = [&](int steps) {
      const auto stepper = make(model);
      State found = s;
      found.a.setZero();
      stepper->start(found);
      for (int k = 1; k <= steps; ++k) stepper->step(found, end / steps, k * end / steps);
      return found;
    };
    const State coarse = run(100), fine = run(200);
    const auto falls = [](const VectorXd& a, const VectorXd& b, const VectorXd& exact) {
      return (b - exact).norm() < std::max((a - exact).norm() / 3.4, 1e-6);
    };
    EXPECT_TRUE(falls(coarse.q, fine.q, expected.q)) << (fine.q - expected.q).norm();
    EXPECT_TRUE(falls(coarse.v, fine.v, expected.v)) << (fine.v - expected.v).norm();
    EXPECT_TRUE(falls(coarse.a, fine.a, expected.a)) << (fine.a - expected.a).norm();
    EXPECT_TRUE(falls(coarse.lambda, fine.lambda, expected.lambda)) << (fine.lambda - expected.lambda).norm();
    EXPECT_LT((fine.q - expected.q).norm(), 5e-4);
    EXPECT_LT((fine.lambda - expected.lambda).norm(), 2e-3 * expected.lambda.norm());
  }
};
INSTANTIATE_TEST_SUITE_P(Each, EachStepperAndIda, testing::ValuesIn(stepper_names()),
                         [](const auto& p) { return p.param.formulation + "_" + p.param.integrator; });

TEST_P(EachStepperAndIda, AgreeOnADrivenPendulum) {
  test::DrivenPendulum pendulum({});
  expect_agreement(pendulum, pendulum.at(0.0, 0.4, 1.0), 1.0);
}

TEST_P(EachStepperAndIda, AgreeOnTheLinkage) {
  Mechanism linkage(read_mechanism("linkage", four_bar::text(2)));
  expect_agreement(linkage, linkage.described_state(), 0.5);
}

}  // namespace
}  // namespace tandem::mbs
#endif
