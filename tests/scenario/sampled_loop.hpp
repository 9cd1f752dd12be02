// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <limits>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "long_run.hpp"
#include "scratch.hpp"
#include "tandem/sampled.hpp"

/// Oscillators and a controller that samples them, as a scenario and as matrix exponentials.
namespace tandem::test {

using Eigen::MatrixXd;

struct Gains {
  double k, d, i;  ///< of position, velocity, and the sum of positions
  double period, offset, latency;
};

/// F = -(k x + d v + s), then s becomes s + i T x.
class Controller {
 public:
  explicit Controller(const Gains& gains) : gains_(gains) {}
  SubsystemInfo info() const {
    return {"controller", {{"x", "m"}, {"v", "m/s"}}, {{"F", "N"}}, {{0, 0}, {0, 1}}, {}};
  }
  double own_step() const { return gains_.period; }
  double offset() const { return gains_.offset; }
  double latency() const { return gains_.latency; }
  void start(double, std::span<const double>) { s_ = 0.0; }
  void outputs(double* y) const { *y = -s_; }
  void outputs(double* y, std::span<const double> u) const { *y = -(gains_.k * u[0] + gains_.d * u[1] + s_); }
  void step(const OwnStep& s, std::span<const Signal> u) {
    s_ += gains_.i * gains_.period * u[0].value(s.begin);
  }

 private:
  Gains gains_;
  double s_ = 0.0;
};

inline Builtins with_controller(const Gains& gains) {
  Builtins all = sources();
  all.models["controller"] = {{}, [gains](const Address&, Parameters&) -> std::unique_ptr<Subsystem> {
                                return std::make_unique<Sampled<Controller>>(Controller(gains));
                              }};
  return all;
}

inline std::string connection(const std::string& from, const std::string& to, const std::string& more) {
  return "[[connections]]\nfrom = '" + from + "'\nto = '" + to + "'\n" + more + "\n";
}

/// Sides that are exact for held forces; the coupling is a spring of which each gets the force.
inline scenario::Scenario scene_of(const Scratch& folder, const std::vector<double>& steps, double coupling,
                                   const std::string& schedule, double stop) {
  std::string text = "[coordination]\nschedule = '" + schedule + fmt::format("'\n[span]\nstop = {}\n", stop);
  for (std::size_t k = 0; k < steps.size(); ++k)
    text += fmt::format(
        "[subsystems.side{0}]\nsource = 'builtin:oscillator.side1'\nparameters = {{ mass = {1}, stiffness = "
        "{2}, "
        "damping = 0.2, x = 1, step = {3} }}\n",
        k + 1, 1.0 + static_cast<double>(k), 1.0 + 2.0 * static_cast<double>(k), steps[k]);
  text += "[subsystems.control]\nsource = 'builtin:controller'\n" +
          connection("side1.x", "control.x", "reconstruction = 'lagrange2'") +
          connection("side1.v", "control.v", "reconstruction = 'lagrange2'") +
          connection("control.F", "side1.F", steps.size() > 1 ? "add = true" : "");
  for (const auto& [from, to, sign] : {std::tuple{"side2.x", "side1.F", 1},
                                       {"side1.x", "side1.F", -1},
                                       {"side1.x", "side2.F", 1},
                                       {"side2.x", "side2.F", -1}})
    if (steps.size() > 1)
      text += connection(from, to,
                         fmt::format("add = true\ngain = {}\nreconstruction = 'lagrange2'", sign * coupling));
  auto one = scenario::read(folder.write("s.toml", text));
  one.coordination.start = StartKind::cold;
  one.coordination.diverged_beyond = std::numeric_limits<double>::infinity();
  return one;
}

inline double radius_of(const MatrixXd& map) { return map.eigenvalues().cwiseAbs().maxCoeff(); }

/// From one instant to the next: x, v, s, the force that acts, and the one that is new.
inline MatrixXd exact_map(const Gains& g) {
  const auto moved = [](double t) {
    MatrixXd rates = MatrixXd::Zero(3, 3);
    rates << 0.0, 1.0, 0.0, -1.0, -0.2, 1.0, 0.0, 0.0, 0.0;
    return MatrixXd((rates * t).exp());
  };
  MatrixXd early = MatrixXd::Identity(5, 5), late = early, swap = early, act = early;
  const MatrixXd a = moved(g.latency), b = moved(g.period - g.latency);
  early.topLeftCorner(2, 2) = a.topLeftCorner(2, 2), early.block(0, 3, 2, 1) = a.block(0, 2, 2, 1);
  swap.row(3) = VectorXd::Unit(5, 4).transpose();
  late.topLeftCorner(2, 2) = b.topLeftCorner(2, 2), late.block(0, 3, 2, 1) = b.block(0, 2, 2, 1);
  act.row(4) << -g.k, -g.d, -1.0, 0.0, 0.0;
  act(2, 0) = g.i * g.period;
  return act * late * swap * early;
}
inline double exact_radius(const Gains& g) { return radius_of(exact_map(g)); }

/// Number k of many; the sum's least gain, and the longest latency in periods.
inline Gains gains_by_chance(std::mt19937_64& random, int k, double least_sum, double longest) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const double period = between(0.1, 1.0);
  return {between(0.0, 8.0),
          between(0.0, 2.0),
          between(least_sum, 2.0),
          period,
          k % 3 == 0 ? 0.0 : between(0.0, 2.5) * period,
          k % 2 == 0 ? 0.0 : between(0.0, longest) * period};
}

/// Of the controller's period: the side's own step.
inline double part_of_period(int k) {
  const double parts[] = {1.0, 0.5, 0.2, 2.0 / 3.0};
  return parts[k % 4];
}

}  // namespace tandem::test
