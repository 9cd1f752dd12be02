// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/sweep.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "four_bar/linkage.hpp"
#include "tandem/output/files.hpp"

namespace tandem::four_bar {
namespace {

constexpr double step = 1.25e-3, short_step = 1e-3;  // [s]
constexpr double rough = 1e-5, fine = 1e-10;         // [m]

Case index3(int loops, double h, double tolerance) {
  Case c{loops, {}, h, ""};
  c.stepper.index3.penalty = sweep_alpha;
  c.stepper.index3.tolerance = tolerance;
  return c;
}

Case unmerged(int loops, const mbs::StepperNames& names, double h) {
  Case c{loops, {}, h, ""};
  c.stepper.formulation = names.formulation;
  c.stepper.integrator = names.integrator;
  if (names.formulation == "penalty") c.stepper.penalty.penalty = sweep_alpha;
  if (names.formulation == "index1") c.stepper.index1.penalty = sweep_alpha;
  return c;
}

/// The default, at all steps: each with its half where there is time for it.
void add_index3(std::vector<Case>& all) {
  for (const int loops : {1, 2, 5, 10, 20, 40, 100, 500, 4000})
    for (const double tolerance : {rough, fine})
      for (const double h : {2 * step, 2 * short_step, step, short_step, step / 2})
        if (h >= short_step || loops < 4000) all.push_back(index3(loops, h, tolerance));
}

template <class Change>
void add_variant(std::vector<Case>& all, const Case& c, const char* settings, const Change& change) {
  all.push_back(c);
  all.back().settings = settings;
  change(all.back().stepper.index3);
}

void add_variants(std::vector<Case>& all) {
  using Settings = mbs::Index3Settings;
  for (const int loops : {1, 2, 5, 10, 20, 40, 100, 500, 4000})
    for (const double tolerance : {rough, fine}) {
      const Case c = index3(loops, step, tolerance);
      add_variant(all, c, "projections = 1", [](Settings& s) { s.projections = 1; });
      if (loops <= 500) add_variant(all, c, "penalty by default", [](Settings& s) { s.penalty = 0.0; });
      if (loops <= 40)
        add_variant(all, c, "carry_multipliers", [](Settings& s) { s.carry_multipliers = true; });
      if (tolerance > fine) continue;
      add_variant(all, c, "multiplier_iterations = 1", [](Settings& s) { s.multiplier_iterations = 1; });
      if (loops <= 40)
        add_variant(all, c, "multiplier_iterations = 30", [](Settings& s) { s.multiplier_iterations = 30; });
    }
}

/// null_space has dense matrices, of which a QR decomposition is made in each evaluation.
void add_others(std::vector<Case>& all) {
  for (const mbs::StepperNames& names : mbs::stepper_names())
    for (const int loops : {1, 2, 5, 10, 20, 40})
      for (const double h : {step, short_step})
        if (names.formulation != "index3" && (names.formulation != "null_space" || loops <= 10))
          all.push_back(unmerged(loops, names, h));
}

bool is_merged(const Case& c) { return c.stepper.formulation == "index3"; }

/// The one with the settings of `c` and twice its step, or -1.
int coarser(const std::vector<Case>& cases, const Case& c) {
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const mbs::StepperSettings &a = cases[k].stepper, &b = c.stepper;
    if (cases[k].loops == c.loops && cases[k].step == 2 * c.step && a.formulation == b.formulation &&
        a.integrator == b.integrator && a.index3 == b.index3)
      return static_cast<int>(k);
  }
  return -1;
}

std::string order(const std::vector<Case>& cases, const std::vector<Result>& results, std::size_t k) {
  const int twice = coarser(cases, cases[k]);
  if (twice < 0 || results[k].status != "ok" || results[twice].status != "ok") return "";
  return fmt::format("{:.2f}", std::log2(results[twice].x_error / results[k].x_error));
}

}  // namespace

std::vector<Case> sweep_cases() {
  std::vector<Case> all;
  add_index3(all);
  add_variants(all);
  add_others(all);
  return all;
}

double sweep_cost(const Case& c) {
  const double n = 2.0 * c.loops + 2.0, steps = sweep_end / c.step;
  const double ns = !is_merged(c)                       ? 1000.0
                    : c.stepper.index3.tolerance > fine ? 80.0
                                                        : 120.0 + 3.0 * std::min(c.loops, 100);
  return 1e-9 * ns * n * steps;
}

std::string sweep_table(const std::vector<Case>& cases, const std::vector<Result>& results) {
  std::string text =
      "loops,formulation,integrator,settings,step,newton_tolerance,iterations_per_step,x_error,order,energy_"
      "drift,"
      "position_residual,velocity_residual,acceleration_residual,largest_tilt,end,status\n";
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Case& c = cases[k];
    const Result& r = results[k];
    text += fmt::format("{},{},{},{},{},{},{:.3f},{},{},{:.2e},{:.1e},{:.1e},{:.1e},{:.1e},{:.6g},{}\n",
                        c.loops, c.stepper.formulation, c.stepper.integrator, c.settings, c.step,
                        is_merged(c) ? fmt::format("{}", c.stepper.index3.tolerance) : "", r.iterations,
                        r.status == "ok" ? fmt::format("{:.3e}", r.x_error) : "", order(cases, results, k),
                        r.energy_drift, r.position_residual, r.velocity_residual, r.acceleration_residual,
                        r.largest_tilt, r.time, r.status);
  }
  return text;
}

void write_traces(const std::filesystem::path& file) {
  constexpr int loops = 2;
  constexpr double begin = 0.6, end = 1.35;  // [s]
  std::vector<double> exact_angles;          // by step
  for (int k = 0; k <= std::lround(end / step); ++k)
    exact_angles.push_back(k * step < begin ? 0.0 : exact(loops, k * step).angle);
  std::string text = "formulation,integrator,time,exact_angle,tilt,angle_error\n";
  for (const mbs::StepperNames& names : mbs::stepper_names()) {
    const Case c = names.formulation == "index3" ? index3(loops, step, fine) : unmerged(loops, names, step);
    run(c, end, [&](const Place& place) {
      const double angle = exact_angles.at(std::lround(place.time / step));
      if (place.time >= begin)
        text += fmt::format("{},{},{:.5f},{:.6f},{:.3e},{:.3e}\n", names.formulation, names.integrator,
                            place.time, angle, place.tilt,
                            std::remainder(place.angle - angle, 2.0 * std::numbers::pi));
    });
  }
  output::write_text(file, text);
}

}  // namespace tandem::four_bar
