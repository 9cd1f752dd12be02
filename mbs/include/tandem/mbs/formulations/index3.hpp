// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "tandem/mbs/formulations/terms.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::mbs {

class MergedFrequency;

struct Index3Settings {
  /// alpha; 0: 1e7 times the largest mass term, and (1 ms / h)^2 times that for steps h below 1 ms.
  double penalty = 0.0;
  /// [s]. Shorter steps h, such as steps cut at events, have own_step / h times alpha. Steps below a fiftieth
  /// of it go on with the acceleration at their begin. 0: none is cut. make_subsystem() puts its own step
  /// here.
  double own_step = 0.0;
  double beta = 0.25;  ///< Newmark's, 1/12 to 1/4; gamma is 1/2. 1/4: the trapezoidal rule
  /// Newton's iteration ends when |dq| (Euclidean) is below [m]; 0: 1e-10 of the model's length.
  double tolerance = 0.0;
  int most_iterations = 30;        ///< then it has failed
  int multiplier_iterations = 10;  ///< of these update the multipliers; the others keep them
  /// Of velocities and of accelerations at most. They end when a change of velocities is below tolerance / h,
  /// of accelerations below tolerance / h^2.
  int projections = 10;
  bool carry_multipliers = false;  ///< a step begins with the multipliers of the one before, not with zero
  std::string solver = "auto";
  /// Threads that share the loops over a large model's constraints, variables and matrix entries. The states
  /// are the same, bit for bit, with any number. More than 1 needs a build with OpenMP.
  int threads = 1;
  int threads_from = 40000;  ///< loops over fewer elements are not shared (docs/threads.md)

  bool operator==(const Index3Settings&) const = default;
};

/// Whether this tandem was built with OpenMP.
bool threads_are_built_in();

/// Index-3 augmented Lagrangian formulation with Newmark's method merged in, and mass-orthogonal projections
/// of velocities and accelerations (E. Bayo, R. Ledesma, Nonlinear Dynamics 9 (1996) 113; J. Cuadrado et al.,
/// Multibody System Dynamics 4 (2000) 55). A step solves, in the positions of its end,
///   f = beta h^2 [M q'' + Phi_q^T (lambda + alpha Phi) - Q] = 0
/// by Newton's method with the tangent T = M + h/2 C + beta h^2 (K + alpha Phi_q^T Phi_q), from the positions
/// that constant acceleration leads to. After each correction lambda <- lambda + alpha Phi. Then, with the
/// last T, velocities with the Phi_q that it was made of and accelerations with that of the end,
///   T dv = -beta h^2 alpha Phi_q^T (Phi_q q' + Phi_t),  T da = -beta h^2 alpha Phi_q^T (Phi_q q'' + gamma).
/// (The literature writes T q' = (T - beta h^2 alpha Phi_q^T Phi_q) q'* - beta h^2 alpha Phi_q^T Phi_t, which
/// is the same.) The lambda that the iteration ends with belongs to the accelerations before the projection
/// and is of order 1. A step leaves another lambda in the state, of order 2:
///   lambda + beta h^2 alpha (Phi_q q'' + gamma) summed over q'' after each projection,
/// since M da = -Phi_q^T beta h^2 alpha (Phi_q q'' + gamma) - (h/2 C + beta h^2 K) da.
///
/// Steps that are cut: constraints are held by alpha h^2, so alpha rises as h falls. Newmark's accelerations
/// are differences of positions, 4 dq / h^2. In the shortest steps they would be what the iteration leaves in
/// dq. There they stay as they are, and velocities are off by h^2/2 times their rate.
class Index3 final : public Stepper {
 public:
  /// `model` must outlive it. Throws Error for a setting that is not allowed.
  Index3(Model& model, const Index3Settings& settings);
  ~Index3() override;

  /// By the augmented Lagrangian of index 1 (Terms::settle).
  void start(State& state) override;
  /// With beta below 1/4 a step is refused, Error(numerical), for two reasons:
  /// - omega h is above 1/sqrt(1/4 - beta), omega the highest frequency of the motion that the constraints
  ///   leave, looked at in every fiftieth step.
  /// - All `projections` together leave so much of the error of velocities that the next step makes it larger
  ///   than it was. Newmark's formulas multiply the error by newmark_growth(beta) where Phi = 0 is held at
  ///   both ends. A projection leaves 1/(1 + beta h^2 alpha sigma^2) of it, sigma a singular value of Phi_q
  ///   in the metric of the mass. That is a limit for steps that are too short.
  int step(State& state, double h, double t_end) override;
  /// Accelerations and multipliers change by what the forces do, and by gamma. What the projection has left
  /// of the constraints stays left: forcing it to zero where constraints hardly hold (a flat position) would
  /// make accelerations without bound. As start(), but with the tangent of the last step. If that has not
  /// settled after ten substitutions (the steps are too short for that), with one of its own, from then on
  /// always. What has not settled then, where constraints hardly hold, stays as it is.
  void refresh(State& state) override;
  TangentFactors tangent_factors(double h) const override;
  void remember(std::vector<double>& to) const override;
  void recall(std::span<const double> memory) override;

 private:
  double penalty(double h) const;
  bool settle_anew(State& s);
  bool settle(State& s, int most);
  void predict(State& s, double h, double t_end);
  bool is_short(double h) const;
  void extrapolate(State& s, double h);
  double correct(State& s, double h);
  void add_correction(State& s, double h);
  void refuse_unstable(const State& s, double h);
  void project_velocities(State& s, double tolerance);
  void refuse_growth(const State& s, double before);
  void project_accelerations(State& s, double tolerance);

  Index3Settings settings_;
  Terms terms_;
  double tolerance_;      ///< [m].
  double penalty_;        ///< Of the last step.
  Eigen::VectorXd left_;  ///< Phi_q q'' + gamma after the last projection.
  double weight_ = 0.0;   ///< Of Phi_q^T Phi_q in the tangent at hand; 0: there is none of use.
  std::unique_ptr<MergedFrequency> highest_;  ///< With beta below 1/4.
  double frequency_ = 0.0;  ///< The highest when it was looked at last, with beta below 1/4 [rad/s].
  long steps_ = 0;          ///< With beta below 1/4.
  bool needs_own_ = false;  ///< `refresh()` could not do with the tangent of a step.
};

}  // namespace tandem::mbs
