// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <string>
#include <vector>

#include "tandem/engine/integrators/adaptive.hpp"
#include "tandem/engine/integrators/runge_kutta.hpp"

namespace tandem::engine {

/// The functions of one integrator of SUNDIALS, which do the same under other names. Those that return an int
/// give a flag, negative for an error.
struct SundialsMethod {
  using Rates = int (*)(double, N_Vector, N_Vector, void*);
  using Roots = int (*)(double, N_Vector, double*, void*);
  using Jacobian = int (*)(double, N_Vector, N_Vector, SUNMatrix, void*, N_Vector, N_Vector, N_Vector);
  using Messages = void (*)(int, const char*, const char*, char*, void*);
  const char* name;
  void* (*create)(Rates rates, double t, N_Vector x, SUNContext context);
  void (*free)(void** memory);
  int (*set_messages)(void* memory, Messages take, void* self);
  int (*set_self)(void* memory, void* self);
  int (*set_tolerances)(void* memory, double relative, double absolute);
  /// Slower with few states: a step of ERKStep with 2 by a tenth.
  int (*set_tolerance_of_each)(void* memory, double relative, N_Vector absolute);
  /// Of Newton's method; null: none. Else that of a fixed-point iteration; null: explicit.
  int (*set_linear_solver)(void* memory, SUNLinearSolver solver, SUNMatrix matrix);
  /// In place of SUNDIALS' own differences.
  int (*set_jacobian)(void* memory, Jacobian jacobian);
  int (*set_nonlinear_solver)(void* memory, SUNNonlinearSolver solver);
  int (*set_longest_step)(void* memory, double step);
  int (*set_shortest_step)(void* memory, double step);
  int (*set_roots)(void* memory, int count, Roots watch);
  int (*set_no_warning)(void* memory);
  int (*start_anew)(void* memory, Rates rates, double t, N_Vector x);
  /// Of a multistep method, to which the first step after the last restart is a good guess; null: it always
  /// finds one. 0: it finds one.
  int (*set_first_step)(void* memory, double step);
  int (*first_step)(void* memory, double* step);     ///< that it took
  int (*set_fixed_step)(void* memory, double step);  ///< null: adaptive
  int (*set_stop_time)(void* memory, double t);
  int (*step)(void* memory, double t_end, N_Vector x, double* t);
  /// Since it was started anew; null: there are none.
  using Count = int (*)(void* memory, long* count);
  Count failed_error_tests, nonlinear_iterations, failed_iterations, jacobians;
};

class SundialsSteps final : public AdaptiveIntegrator {
 public:
  SundialsSteps(const SundialsMethod& method, const AdaptiveSettings& settings);
  ~SundialsSteps() override;
  SundialsSteps(const SundialsSteps&) = delete;
  SundialsSteps& operator=(const SundialsSteps&) = delete;

  void check_fit(const std::vector<std::string>& names) const override;
  void restart(DifferentialSystem& system, double t, Restart why) override;
  double advance(DifferentialSystem& system, double t, double t_end) override;
  bool has_fixed_steps() const { return method_.set_fixed_step != nullptr; }
  Statistics statistics() const;

 private:
  static int rates(double t, N_Vector x, N_Vector dx, void* self);
  static int jacobian(double t, N_Vector x, N_Vector dx, SUNMatrix j, void* self, N_Vector, N_Vector,
                      N_Vector);
  static int watch(double t, N_Vector x, double* g, void* self);
  static void take_message(int code, const char* module, const char* function, char* message, void* self);

  void create(double t);
  void create_linear_solver();
  void set_tolerances();
  double first_step(Restart why) const;
  void step(double t_end);
  void refuse_standstill(double from);
  void check(int flag) const;
  template <class Work>
  bool survives(const Work& work);

  const SundialsMethod& method_;
  AdaptiveSettings settings_;
  SUNContext context_ = nullptr;
  N_Vector x_ = nullptr, absolute_ = nullptr;  ///< the second: tolerances
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  SUNNonlinearSolver iteration_ = nullptr;
  void* memory_ = nullptr;
  DifferentialSystem* system_ = nullptr;
  double time_ = 0.0;
  long steps_ = 0;    ///< on the way to the time that it is asked for
  int standing_ = 0;  ///< steps in a row that time does not show
  std::string message_, failure_;
  std::string not_finite_;  ///< which block made the last derivative that was not finite, and when
  Statistics statistics_;   ///< of its counts up to the last restart
};

/// The same, of diagrams.
class SundialsIntegrator final : public Integrator {
 public:
  SundialsIntegrator(const SundialsMethod& method, const AdaptiveSettings& settings)
      : steps_(method, settings) {}

  void check_fit(const std::vector<std::string>& names) const override { steps_.check_fit(names); }
  void restart(System& system, double t, Restart why) override {
    system.size() == 0 ? still_.restart(system, t, why) : steps_.restart(system, t, why);
  }
  double advance(System& system, double t, double t_end) override {
    return system.size() == 0 ? still_.advance(system, t, t_end) : steps_.advance(system, t, t_end);
  }
  bool chooses_steps() const override { return true; }
  bool goes_by_image() const override { return steps_.has_fixed_steps(); }
  Statistics statistics() const override { return steps_.statistics(); }

 private:
  SundialsSteps steps_;
  RungeKutta4 still_;  ///< of a system without states, of which SUNDIALS has none
};

}  // namespace tandem::engine
