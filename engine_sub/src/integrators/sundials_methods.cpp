// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>

#include "sundials_integrator.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {
namespace {

template <int method>
void* create_cvode(SundialsMethod::Rates rates, double t, N_Vector x, SUNContext context) {
  void* const memory = CVodeCreate(method, context);
  CVodeInit(memory, rates, t, x);
  return memory;
}

template <int method>
constexpr SundialsMethod cvode(const char* name) {
  SundialsMethod all{};
  all.name = name;
  all.create = create_cvode<method>;
  all.free = CVodeFree;
  all.set_messages = CVodeSetErrHandlerFn;
  all.set_self = CVodeSetUserData;
  all.set_tolerances = CVodeSStolerances;
  all.set_tolerance_of_each = CVodeSVtolerances;
  if (method == CV_ADAMS)
    all.set_nonlinear_solver = CVodeSetNonlinearSolver;
  else
    all.set_linear_solver = CVodeSetLinearSolver;
  all.set_jacobian = CVodeSetJacFn;
  all.set_longest_step = CVodeSetMaxStep;
  all.set_shortest_step = CVodeSetMinStep;
  all.set_roots = CVodeRootInit;
  all.set_no_warning = CVodeSetNoInactiveRootWarn;
  all.start_anew = [](void* m, SundialsMethod::Rates, double t, N_Vector x) { return CVodeReInit(m, t, x); };
  all.set_first_step = CVodeSetInitStep;
  all.first_step = CVodeGetActualInitStep;
  all.set_stop_time = CVodeSetStopTime;
  all.step = [](void* m, double t_end, N_Vector x, double* t) { return CVode(m, t_end, x, t, CV_ONE_STEP); };
  all.failed_error_tests = CVodeGetNumErrTestFails;
  all.nonlinear_iterations = CVodeGetNumNonlinSolvIters;
  all.failed_iterations = CVodeGetNumNonlinSolvConvFails;
  if (method == CV_BDF) all.jacobians = CVodeGetNumJacEvals;
  return all;
}

constexpr SundialsMethod erkstep_method(const char* name, bool fixed) {
  SundialsMethod all{};
  all.name = name;
  all.create = ERKStepCreate;
  all.free = ERKStepFree;
  all.set_messages = ERKStepSetErrHandlerFn;
  all.set_self = ERKStepSetUserData;
  all.set_tolerances = ERKStepSStolerances;
  all.set_tolerance_of_each = ERKStepSVtolerances;
  all.set_longest_step = ERKStepSetMaxStep;
  all.set_shortest_step = ERKStepSetMinStep;
  all.set_roots = ERKStepRootInit;
  all.set_no_warning = ERKStepSetNoInactiveRootWarn;
  all.start_anew = ERKStepReInit;
  if (fixed) all.set_fixed_step = ERKStepSetFixedStep;
  all.set_stop_time = ERKStepSetStopTime;
  all.step = [](void* m, double t_end, N_Vector x, double* t) {
    return ERKStepEvolve(m, t_end, x, t, ARK_ONE_STEP);
  };
  all.failed_error_tests = ERKStepGetNumErrTestFails;
  return all;
}

constexpr SundialsMethod arkstep_method() {
  SundialsMethod all{};
  all.name = "arkstep";
  all.create = [](SundialsMethod::Rates rates, double t, N_Vector x, SUNContext context) {
    return ARKStepCreate(nullptr, rates, t, x, context);
  };
  all.free = ARKStepFree;
  all.set_messages = ARKStepSetErrHandlerFn;
  all.set_self = ARKStepSetUserData;
  all.set_tolerances = ARKStepSStolerances;
  all.set_tolerance_of_each = ARKStepSVtolerances;
  // By default ARKStep takes the rate of convergence from steps before, which a step cut at a stop time does
  // not have: x' = 1 - x to 1e-9, stopped each 1/8 s, was wrong by 1e-5.
  all.set_linear_solver = [](void* m, SUNLinearSolver solver, SUNMatrix matrix) {
    const int flag = ARKStepSetLinearSolver(m, solver, matrix);
    return flag < 0 ? flag : ARKStepSetNonlinCRDown(m, 1.0);
  };
  all.set_jacobian = ARKStepSetJacFn;
  all.set_longest_step = ARKStepSetMaxStep;
  all.set_shortest_step = ARKStepSetMinStep;
  all.set_roots = ARKStepRootInit;
  all.set_no_warning = ARKStepSetNoInactiveRootWarn;
  all.start_anew = [](void* m, SundialsMethod::Rates rates, double t, N_Vector x) {
    return ARKStepReInit(m, nullptr, rates, t, x);
  };
  all.set_stop_time = ARKStepSetStopTime;
  all.step = [](void* m, double t_end, N_Vector x, double* t) {
    return ARKStepEvolve(m, t_end, x, t, ARK_ONE_STEP);
  };
  all.failed_error_tests = ARKStepGetNumErrTestFails;
  all.nonlinear_iterations = ARKStepGetNumNonlinSolvIters;
  all.failed_iterations = ARKStepGetNumNonlinSolvConvFails;
  all.jacobians = ARKStepGetNumJacEvals;
  return all;
}

const SundialsMethod adams = cvode<CV_ADAMS>("cvode_adams"), bdf = cvode<CV_BDF>("cvode_bdf");
const SundialsMethod erk = erkstep_method("erkstep", false),
                     erk_fixed = erkstep_method("erkstep_fixed", true);
const SundialsMethod ark = arkstep_method();

const SundialsMethod* const methods[] = {&adams, &bdf, &erk, &erk_fixed, &ark};

template <class Made, class As>
std::unique_ptr<As> made(const std::string& name, const AdaptiveSettings& settings) {
  for (const SundialsMethod* method : methods)
    if (name == method->name) {
      if (method->set_fixed_step) refuse_settings(name, settings);
      return std::make_unique<Made>(*method, settings);
    }
  return nullptr;
}

}  // namespace

std::vector<std::string> adaptive_names() {
  std::vector<std::string> names;
  for (const SundialsMethod* method : methods) names.push_back(method->name);
  return names;
}

void refuse_settings(const std::string& name, const AdaptiveSettings& settings) {
  if (settings != AdaptiveSettings{})
    throw Error(ErrorCode::invalid_argument,
                "tolerances and limits of an adaptive integrator are given, but " + name +
                    " is chosen; allowed is to leave them out");
}

std::unique_ptr<AdaptiveIntegrator> adaptive_integrator(const std::string& name,
                                                        const AdaptiveSettings& settings) {
  return made<SundialsSteps, AdaptiveIntegrator>(name, settings);
}

std::unique_ptr<Integrator> adaptive_integrator_of_diagrams(const std::string& name,
                                                            const AdaptiveSettings& settings) {
  return made<SundialsIntegrator, Integrator>(name, settings);
}

}  // namespace tandem::engine
