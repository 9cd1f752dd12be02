// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tandem/mbs/integrators/integrator.hpp"

namespace tandem::mbs {

struct NewmarkSettings {
  double beta = 0.25;        ///< 1/12 to 1/4; 1/4: the trapezoidal rule. Newmark's gamma is 1/2
  double tolerance = 0.0;    ///< [m/s] see NewmarkFamily; 0: 1e-10 of the problem's length in a second
  int most_iterations = 30;  ///< then it has failed

  bool operator==(const NewmarkSettings&) const = default;
};

struct GeneralizedAlphaSettings {
  double spectral_radius = 0.8;  ///< what is left of the highest frequencies after a step, 0 to 1
  double tolerance = 0.0;        ///< as there
  int most_iterations = 30;

  bool operator==(const GeneralizedAlphaSettings&) const = default;
};

/// Newmark's method and the generalized-alpha method, with accelerations w of their own:
///   y+ = y + h v + h^2 [(1/2 - beta) w + beta w+],  v+ = v + h [(1 - gamma) w + gamma w+],
///   (1 - alpha_m) w+ + alpha_m w = (1 - alpha_f) f+ + alpha_f f,  f+ = f(t+, y+, v+)
/// (J. Chung, G. Hulbert, J. Appl. Mech. 60 (1993) 371, with the mean of the forces for the force at the mean
/// motion, as in M. Arnold, O. Bruls, Multibody System Dynamics 18 (2007) 185; the same for linear
/// problems). Newmark: alpha_m = alpha_f = 0, so that w = f. Generalized alpha of spectral radius rho:
/// alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), gamma = 1/2 - alpha_m + alpha_f,
/// beta = (1 - alpha_m + alpha_f)^2/4. Between steps it keeps w - f; a motion that jumps keeps it too.
///
/// f+ comes from fixed-point iteration, from f on, until gamma h |df| <= tolerance (Euclidean, absolute:
/// forces that balance leave rounding; by default not below that of v). It converges for beta (omega h)^2 < 1
/// (Newmark).
///
/// With beta < 1/4 Newmark's method is stable for
///   omega h < 1/sqrt(1/4 - beta),
/// whatever the damping (T. Hughes, The Finite Element Method, 1987, sect. 9.1). Every fiftieth step, the
/// first of them, begins with the spectral radius omega^2 of df/dy by power iteration with differences, in
/// 100 evaluations. A step beyond the limit is refused.
class NewmarkFamily final : public Integrator {
 public:
  /// Throw Error for a setting that is not allowed.
  explicit NewmarkFamily(const NewmarkSettings& settings);
  explicit NewmarkFamily(const GeneralizedAlphaSettings& settings);

  void start(SecondOrder& problem, const Motion& motion) override;
  int step(SecondOrder& problem, Motion& motion, double h, double t_end) override;
  void remember(std::vector<double>& to) const override;
  void recall(std::span<const double> memory) override;

 private:
  void refuse_unstable(SecondOrder& problem, const Motion& motion, double h);
  void advance(const Motion& from, Motion& to, double h);
  double tolerance(const SecondOrder& problem, const Motion& motion) const;

  double alpha_m_ = 0.0, alpha_f_ = 0.0, beta_, gamma_ = 0.5, tolerance_;
  int most_iterations_;
  double frequency_ = 0.0;  ///< the highest, if there is a limit [rad/s]
  int steps_ = 0;           ///< since that was looked at
  Motion end_;
  Eigen::VectorXd lag_, w_, w_end_, change_;  ///< lag: w - f
};

}  // namespace tandem::mbs
