// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>

#include "sundials_integrator.hpp"

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
  return {name,
          create_cvode<method>,
          CVodeFree,
          CVodeSetErrHandlerFn,
          CVodeSetUserData,
          CVodeSStolerances,
          CVodeSetLinearSolver,
          CVodeSetMaxStep,
          CVodeRootInit,
          CVodeSetNoInactiveRootWarn,
          [](void* m, SundialsMethod::Rates, double t, N_Vector x) { return CVodeReInit(m, t, x); },
          CVodeSetStopTime,
          [](void* m, double t_end, N_Vector x, double* t) { return CVode(m, t_end, x, t, CV_ONE_STEP); },
          CVodeGetRootInfo};
}

const SundialsMethod adams = cvode<CV_ADAMS>("cvode_adams"), bdf = cvode<CV_BDF>("cvode_bdf");
const SundialsMethod erk = {
    "erkstep",
    ERKStepCreate,
    ERKStepFree,
    ERKStepSetErrHandlerFn,
    ERKStepSetUserData,
    ERKStepSStolerances,
    nullptr,
    ERKStepSetMaxStep,
    ERKStepRootInit,
    ERKStepSetNoInactiveRootWarn,
    ERKStepReInit,
    ERKStepSetStopTime,
    [](void* m, double t_end, N_Vector x, double* t) { return ERKStepEvolve(m, t_end, x, t, ARK_ONE_STEP); },
    ERKStepGetRootInfo};
const SundialsMethod ark = {
    "arkstep",
    [](SundialsMethod::Rates rates, double t, N_Vector x, SUNContext context) {
      return ARKStepCreate(nullptr, rates, t, x, context);
    },
    ARKStepFree,
    ARKStepSetErrHandlerFn,
    ARKStepSetUserData,
    ARKStepSStolerances,
    ARKStepSetLinearSolver,
    ARKStepSetMaxStep,
    ARKStepRootInit,
    ARKStepSetNoInactiveRootWarn,
    [](void* m, SundialsMethod::Rates rates, double t, N_Vector x) {
      return ARKStepReInit(m, nullptr, rates, t, x);
    },
    ARKStepSetStopTime,
    [](void* m, double t_end, N_Vector x, double* t) { return ARKStepEvolve(m, t_end, x, t, ARK_ONE_STEP); },
    ARKStepGetRootInfo};

}  // namespace

std::unique_ptr<Integrator> cvode_adams(const AdaptiveSettings& s) {
  return std::make_unique<SundialsIntegrator>(adams, s);
}
std::unique_ptr<Integrator> cvode_bdf(const AdaptiveSettings& s) {
  return std::make_unique<SundialsIntegrator>(bdf, s);
}
std::unique_ptr<Integrator> erkstep(const AdaptiveSettings& s) {
  return std::make_unique<SundialsIntegrator>(erk, s);
}
std::unique_ptr<Integrator> arkstep(const AdaptiveSettings& s) {
  return std::make_unique<SundialsIntegrator>(ark, s);
}

}  // namespace tandem::engine
