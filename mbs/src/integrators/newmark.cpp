// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/integrators/newmark.hpp"

#include <algorithm>
#include <limits>

#include "check_memory.hpp"
#include "settings.hpp"
#include "tandem/mbs/integrators/frequency.hpp"

namespace tandem::mbs {

NewmarkFamily::NewmarkFamily(const NewmarkSettings& s)
    : beta_(s.beta), tolerance_(s.tolerance), most_iterations_(s.most_iterations) {
  check_beta("Newmark's method", s.beta);
  Setting{"Newmark's method", "tolerance", s.tolerance}.at_least(0.0, "a number above 0");
  Setting{"Newmark's method", "most_iterations", static_cast<double>(s.most_iterations)}.count();
}

NewmarkFamily::NewmarkFamily(const GeneralizedAlphaSettings& s)
    : tolerance_(s.tolerance), most_iterations_(s.most_iterations) {
  const double rho = s.spectral_radius;
  const Setting radius{"generalized-alpha method", "spectral_radius", rho};
  if (!(rho >= 0.0 && rho <= 1.0)) radius.refuse("0 to 1");
  Setting{"generalized-alpha method", "tolerance", s.tolerance}.at_least(0.0, "a number above 0");
  Setting{"generalized-alpha method", "most_iterations", static_cast<double>(s.most_iterations)}.count();
  alpha_m_ = (2.0 * rho - 1.0) / (rho + 1.0);
  alpha_f_ = rho / (rho + 1.0);
  gamma_ = 0.5 - alpha_m_ + alpha_f_;
  beta_ = 0.25 * (1.0 - alpha_m_ + alpha_f_) * (1.0 - alpha_m_ + alpha_f_);
}

void NewmarkFamily::start(SecondOrder& problem, const Motion& motion) {
  lag_.setZero(problem.size());
  end_ = motion;
  w_ = w_end_ = change_ = lag_;
  steps_ = 0;
}

/// The lag, how many steps ago the highest frequency was looked at, and that.
void NewmarkFamily::remember(std::vector<double>& to) const {
  to.insert(to.end(), lag_.begin(), lag_.end());
  to.insert(to.end(), {static_cast<double>(steps_), frequency_});
}

void NewmarkFamily::recall(std::span<const double> memory) {
  check_memory(memory.size() == static_cast<std::size_t>(lag_.size()) + 2);
  std::copy_n(memory.begin(), lag_.size(), lag_.begin());
  steps_ = static_cast<int>(memory[memory.size() - 2]);
  frequency_ = memory.back();
}

void NewmarkFamily::refuse_unstable(SecondOrder& problem, const Motion& motion, double h) {
  if (beta_ >= 0.25) return;
  if (steps_ == 0) frequency_ = highest_frequency(problem, motion);
  steps_ = (steps_ + 1) % steps_between_checks;
  mbs::refuse_unstable("Newmark's method", beta_, frequency_, motion.time, h);
}

/// y+, v+ and w+ from f+ in to.a.
void NewmarkFamily::advance(const Motion& from, Motion& to, double h) {
  w_end_ = ((1.0 - alpha_f_) * to.a + alpha_f_ * from.a - alpha_m_ * w_) / (1.0 - alpha_m_);
  to.y = from.y + h * from.v + h * h * ((0.5 - beta_) * w_ + beta_ * w_end_);
  to.v = from.v + h * ((1.0 - gamma_) * w_ + gamma_ * w_end_);
}

/// A velocity is not known better than to a few of its last digits.
double NewmarkFamily::tolerance(const SecondOrder& problem, const Motion& motion) const {
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  return tolerance_ > 0.0 ? tolerance_ : std::max(1e-10 * problem.length(), rounding * motion.v.norm());
}

int NewmarkFamily::step(SecondOrder& problem, Motion& motion, double h, double t_end) {
  refuse_unstable(problem, motion, h);
  const double most = tolerance(problem, motion);
  w_ = motion.a + lag_;
  end_.time = t_end;
  end_.a = motion.a;
  for (int iteration = 1; iteration <= most_iterations_; ++iteration) {
    advance(motion, end_, h);
    change_ = end_.a;
    problem.accelerations(t_end, end_.y.data(), end_.v.data(), end_.a.data());
    change_ -= end_.a;
    if (!(gamma_ * h * change_.norm() <= most)) continue;
    lag_ = w_end_ - end_.a;
    motion = end_;
    return iteration;
  }
  throw Error(
      ErrorCode::numerical,
      fmt::format(
          "no convergence at t = {} s in {} iterations: the velocities still change by {:.2e} m/s, "
          "allowed is {:.3g} (fixed-point iteration converges for beta (omega h)^2 < 1, beta = {:.4g}); "
          "no shorter step is tried",
          t_end, most_iterations_, gamma_ * h * change_.norm(), most, beta_));
}

}  // namespace tandem::mbs
