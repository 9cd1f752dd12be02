// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sundials_integrator.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

/// Refuses the first setting that is not allowed.
void check_settings(const char* name, const AdaptiveSettings& s) {
  const auto require = [name](const char* setting, double value, bool allowed, const char* what) {
    if (!allowed)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("integrator {}: {} is {}; allowed is {}", name, setting, value, what));
  };
  const auto positive = [&](const char* setting, double value) {
    require(setting, value, value > 0.0 && std::isfinite(value), "a number above 0");
  };
  positive("relative_tolerance", s.relative_tolerance);
  positive("absolute_tolerance", s.absolute_tolerance);
  for (const auto& [state, tolerance] : s.absolute_tolerances)
    positive(("absolute_tolerance." + state).c_str(), tolerance);
  require("longest_step", s.longest_step, s.longest_step >= 0.0, "0 (no limit) or more [s]");
  require("shortest_step", s.shortest_step, s.shortest_step >= 0.0, "0 (no limit) or more [s]");
  positive("most_steps", static_cast<double>(s.most_steps));
}

}  // namespace

SundialsSteps::SundialsSteps(const SundialsMethod& method, const AdaptiveSettings& settings)
    : method_(method), settings_(settings) {
  check_settings(method.name, settings);
  SUNContext_Create(nullptr, &context_);
}

SundialsSteps::~SundialsSteps() {
  if (memory_) method_.free(&memory_);
  if (iteration_) SUNNonlinSolFree(iteration_);
  if (solver_) SUNLinSolFree(solver_);
  if (matrix_) SUNMatDestroy(matrix_);
  for (N_Vector vector : {x_, absolute_})
    if (vector) N_VDestroy(vector);
  SUNContext_Free(&context_);
}

void SundialsSteps::check_fit(const std::vector<std::string>& names) const {
  for (const auto& [state, tolerance] : settings_.absolute_tolerances)
    if (std::find(names.begin(), names.end(), state) == names.end())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("integrator {}: absolute_tolerance.{}: {}", method_.name, state,
                              unknown("state", state, names)));
}

/// Where a derivative is not finite a shorter step is tried.
int SundialsSteps::rates(double t, N_Vector x, N_Vector dx, void* self) {
  SundialsSteps& integrator = *static_cast<SundialsSteps*>(self);
  DifferentialSystem& system = *integrator.system_;
  std::copy_n(N_VGetArrayPointer(x), system.size(), system.states());
  double* const d = N_VGetArrayPointer(dx);
  ++integrator.statistics_.rate_evaluations;
  if (!integrator.survives([&] { system.rates(t, d); })) return 1;
  if (std::all_of(d, d + system.size(), [](double rate) { return std::isfinite(rate); })) return 0;
  const std::string source = system.not_finite();
  if (!source.empty()) integrator.not_finite_ = fmt::format("; {} at t = {} s", source, t);
  return 1;
}

/// Forward differences, whose steps stand out of what algebraic loops leave as an error: by the root of their
/// tolerance. Those of SUNDIALS stand out of rounding alone.
int SundialsSteps::jacobian(  // NOLINT(readability-function-size): SUNDIALS calls it
    double t, N_Vector at, N_Vector dx, SUNMatrix j, void* self, N_Vector rate, N_Vector, N_Vector) {
  const SundialsSteps& integrator = *static_cast<const SundialsSteps*>(self);
  double *const x = N_VGetArrayPointer(at), *const f0 = N_VGetArrayPointer(dx);
  const double* const f = N_VGetArrayPointer(rate);
  const double* const absolute = N_VGetArrayPointer(integrator.absolute_);
  const double tolerance = integrator.system_->rate_error();
  for (int c = 0, n = integrator.system_->size(); c < n; ++c) {
    const double before = x[c],
                 size = std::abs(before) + absolute[c] / integrator.settings_.relative_tolerance;
    x[c] = before + std::sqrt(tolerance) * size;
    const int flag = rates(t, at, rate, self);
    for (int r = 0; r < n; ++r) SM_ELEMENT_D(j, r, c) = (f[r] - f0[r]) / (x[c] - before);
    x[c] = before;
    if (flag != 0) return flag;
  }
  return 0;
}

int SundialsSteps::watch(double t, N_Vector x, double* g, void* self) {
  SundialsSteps& integrator = *static_cast<SundialsSteps*>(self);
  DifferentialSystem& system = *integrator.system_;
  std::copy_n(N_VGetArrayPointer(x), system.size(), system.states());
  ++integrator.statistics_.root_evaluations;
  if (!integrator.survives([&] { system.evaluate(t); })) return -1;
  system.watched_signs(g);
  return 0;
}

void SundialsSteps::take_message(int, const char*, const char* function, char* message, void* self) {
  static_cast<SundialsSteps*>(self)->message_ = fmt::format("{}: {}", function, message);
}

/// No error goes through SUNDIALS, which is C: it is thrown again where SUNDIALS gives up.
template <class Work>
bool SundialsSteps::survives(const Work& work) {
  try {
    work();
    return true;
  } catch (const Error& error) {
    failure_ = error.what();
    return false;
  }
}

void SundialsSteps::check(int flag) const {
  if (flag >= 0) return;
  if (!failure_.empty()) throw Error(ErrorCode::numerical, failure_);
  throw Error(ErrorCode::numerical,
              fmt::format("integrator {} can't go on at t = {} s: {}{}", method_.name, time_,
                          message_.empty() ? fmt::format("error {}", flag) : message_, not_finite_));
}

Statistics SundialsSteps::statistics() const {
  Statistics all = statistics_;
  const auto count = [this](SundialsMethod::Count of) {
    long number = 0;
    if (memory_ && of) of(memory_, &number);
    return number;
  };
  all.failed_error_tests += count(method_.failed_error_tests);
  all.nonlinear_iterations += count(method_.nonlinear_iterations);
  all.failed_iterations += count(method_.failed_iterations);
  all.jacobians += count(method_.jacobians);
  return all;
}

/// After an event as long as after the one before, which saves the evaluations of a search.
double SundialsSteps::first_step(Restart why) const {
  double step = 0.0;
  if (memory_ && why == Restart::event && method_.first_step) method_.first_step(memory_, &step);
  return step;
}

void SundialsSteps::restart(DifferentialSystem& system, double t, Restart why) {
  system_ = &system;
  time_ = t;
  standing_ = 0;
  not_finite_.clear();
  if (!x_) x_ = N_VNew_Serial(system.size(), context_);
  std::copy_n(system.states(), system.size(), N_VGetArrayPointer(x_));
  const double first = first_step(why);
  statistics_ = statistics();
  ++statistics_.restarts;
  memory_ ? check(method_.start_anew(memory_, rates, t, x_)) : create(t);
  if (method_.set_first_step) check(method_.set_first_step(memory_, first));
}

void SundialsSteps::set_tolerances() {
  const auto names = system_->state_names();
  absolute_ = N_VClone(x_);
  const std::span of_each(N_VGetArrayPointer(absolute_), static_cast<std::size_t>(system_->size()));
  std::ranges::transform(system_->nominals(), of_each.begin(),
                         [this](double nominal) { return settings_.absolute_tolerance * nominal; });
  for (const auto& [state, tolerance] : settings_.absolute_tolerances)
    of_each[static_cast<std::size_t>(std::find(names.begin(), names.end(), state) - names.begin())] =
        tolerance;
  check(std::ranges::adjacent_find(of_each, std::not_equal_to<>()) == of_each.end()
            ? method_.set_tolerances(memory_, settings_.relative_tolerance, of_each[0])
            : method_.set_tolerance_of_each(memory_, settings_.relative_tolerance, absolute_));
}

void SundialsSteps::create_linear_solver() {
  matrix_ = SUNDenseMatrix(system_->size(), system_->size(), context_);
  solver_ = SUNLinSol_Dense(x_, matrix_, context_);
  check(method_.set_linear_solver(memory_, solver_, matrix_));
  if (system_->rate_error() > 0.0) check(method_.set_jacobian(memory_, jacobian));
}

void SundialsSteps::create(double t) {
  memory_ = method_.create(rates, t, x_, context_);
  check(method_.set_messages(memory_, take_message, this));
  check(method_.set_self(memory_, this));
  set_tolerances();
  if (method_.set_linear_solver) create_linear_solver();
  if (method_.set_nonlinear_solver) {
    iteration_ = SUNNonlinSol_FixedPoint(x_, 0, context_);
    check(method_.set_nonlinear_solver(memory_, iteration_));
  }
  check(method_.set_longest_step(memory_, settings_.longest_step));
  check(method_.set_shortest_step(memory_, settings_.shortest_step));
  check(method_.set_roots(memory_, system_->watched_signals(), watch));
  check(method_.set_no_warning(memory_));
}

double SundialsSteps::advance(DifferentialSystem& system, double t, double t_end) {
  system.evaluate_again(t);
  if (system.changed() >= 0) return t;  // by an input that has jumped
  time_ = t;
  if (time_ < t_end) step(t_end);
  steps_ = time_ < t_end ? steps_ + 1 : 0;
  refuse_standstill(t);
  if (steps_ > settings_.most_steps)
    throw Error(ErrorCode::numerical,
                fmt::format("integrator {} has taken {} steps at t = {} s, on the way to {} s", method_.name,
                            settings_.most_steps, time_, t_end));
  std::copy_n(N_VGetArrayPointer(x_), system.size(), system.states());
  system.evaluate(time_);
  return time_;
}

/// Where derivatives are numbers up to some time alone, steps get shorter and shorter before it.
void SundialsSteps::refuse_standstill(double from) {
  constexpr int most = 1000;
  constexpr double shortest = 4.0 * std::numeric_limits<double>::epsilon();
  standing_ = time_ - from > shortest * std::abs(from) ? 0 : standing_ + 1;
  if (standing_ > most)
    throw Error(ErrorCode::numerical, fmt::format("integrator {} no longer comes forward at t = {} s{}",
                                                  method_.name, time_, not_finite_));
}

/// One of its steps, not past t_end; it ends at a root.
void SundialsSteps::step(double t_end) {
  static_assert(CV_TSTOP_RETURN == 1, "as in ARKODE");
  if (method_.set_fixed_step) check(method_.set_fixed_step(memory_, t_end - time_));
  check(method_.set_stop_time(memory_, t_end));
  ++statistics_.steps;
  const int flag = method_.step(memory_, t_end, x_, &time_);
  check(flag);
  failure_.clear();
  if (flag == CV_TSTOP_RETURN) time_ = t_end;
}

}  // namespace tandem::engine
