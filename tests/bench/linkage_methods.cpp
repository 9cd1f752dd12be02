// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_methods.hpp"

#include <cmath>

#include "four_bar/integrate.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

constexpr double held = 1e-10;  // [m] tolerance of constraints with which Simbody passes the flat position

const std::vector<double> accuracies = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

/// From 0.1 s on; a whole number of them to the end.
std::vector<double> step_sizes(double end) {
  std::vector<double> all;
  for (double count = std::round(end / 0.1); count < 1e5; count = std::round(1.5 * count))
    all.push_back(end / count);
  return all;
}

std::string second_word(const std::string& name) { return name.substr(name.find(' ') + 1); }

/// The default formulation, with the penalty of the linkage's own file.
mbs::StepperSettings index3(double tolerance, double penalty = 1e8) {
  mbs::StepperSettings settings;
  settings.index3.penalty = penalty;
  settings.index3.tolerance = tolerance;
  return settings;
}

/// A firm hold and no word on multipliers that don't settle are what the flat position needs; omega [rad/s]
/// is greater with the longer steps of rk8, so that what a step leaves of a constraint is gone after some
/// steps.
mbs::StepperSettings by_runge_kutta(const std::string& formulation, const std::string& integrator,
                                    double omega) {
  mbs::StepperSettings settings;
  settings.formulation = formulation;
  settings.integrator = integrator;
  if (formulation == "penalty") settings.penalty = {.penalty = 1e10, .omega = omega};
  if (formulation == "index1")
    settings.index1 = {.penalty = 1e10, .omega = omega, .tolerance = 1e-6, .multiplier_iterations = 50};
  return settings;
}

}  // namespace

LinkageMethods::LinkageMethods(const LinkageMotion& motion, int loops)
    : end_(motion.end),
      rod_(loops, motion.start, simbody::Closing::rod),
      point_on_line_(loops, motion.start, simbody::Closing::point_on_line),
      mechanism_(mbs::read_mechanism("four_bar", four_bar::text(loops, motion.start))) {
  add_by_accuracy("Rod RungeKuttaMerson", rod_);
  add_by_accuracy("PointOnLine RungeKuttaMerson", point_on_line_);
  for (const char* integrator : {"RungeKuttaMerson", "RungeKutta3", "Verlet", "SemiExplicitEuler2"})
    add_by_steps(std::string("Rod ") + integrator, rod_);
  add_by_steps("PointOnLine RungeKuttaMerson", point_on_line_);
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10})
    add_tandem("index3 1e" + std::to_string(std::lround(std::log10(tolerance))), index3(tolerance));
  add_tandem("index3 1e-8 firm", index3(1e-8, 1e10));
  for (const auto& [integrator, omega] : {std::pair{"rk4", 10.0}, {"rk8", 20.0}})
    for (const std::string formulation : {"penalty", "index1"})
      add_tandem(formulation + " " + integrator, by_runge_kutta(formulation, integrator, omega));
}

void LinkageMethods::add_by_accuracy(const std::string& name, const simbody::Linkage& linkage) {
  for (const double tolerance : {0.0, held})
    all_.push_back({"simbody", name + (tolerance > 0.0 ? " held" : ""), accuracies,
                    [=, &linkage, end = end_](double accuracy, double patience) {
                      return linkage.run({second_word(name), accuracy, tolerance, 0.0, patience}, end);
                    }});
}

void LinkageMethods::add_by_steps(const std::string& name, const simbody::Linkage& linkage) {
  all_.push_back(
      {"simbody", name + " fixed", step_sizes(end_), [=, &linkage, end = end_](double step, double patience) {
         return linkage.run({second_word(name), 1e-3, held, step, patience}, end);
       }});
}

void LinkageMethods::add_tandem(const std::string& name, const mbs::StepperSettings& settings) {
  all_.push_back({"tandem", name, step_sizes(end_), [this, settings](double step, double) {
                    const auto stepper = mbs::make_stepper(mechanism_, settings);
                    return four_bar::integrate(mechanism_, *stepper, end_, std::lround(end_ / step));
                  }});
}

}  // namespace tandem::bench
