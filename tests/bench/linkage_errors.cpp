// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <thread>

#include "bench/meter.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/output/parallel.hpp"

namespace tandem::bench {
namespace {

using four_bar::Case;
using four_bar::Result;

constexpr double errors_end = 20.0;                  // [s]
constexpr double penalty_alpha = 1e8;                // where nothing else is said
constexpr double step = 1.25e-3, short_step = 1e-3;  // [s]
constexpr double rough = 1e-5, fine = 1e-10;         // [m]

Case index3(int loops, double h, double tolerance) {
  Case c{loops, {}, h, "default"};
  c.stepper.index3.penalty = penalty_alpha;
  c.stepper.index3.tolerance = tolerance;
  return c;
}

Case unmerged(int loops, const mbs::StepperNames& names, double h) {
  Case c{loops, {}, h, "default"};
  c.stepper.formulation = names.formulation;
  c.stepper.integrator = names.integrator;
  if (names.formulation == "penalty") c.stepper.penalty.penalty = penalty_alpha;
  if (names.formulation == "index1") c.stepper.index1.penalty = penalty_alpha;
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

std::vector<Case> error_cases() {
  std::vector<Case> all;
  add_index3(all);
  add_variants(all);
  add_others(all);
  return all;
}

Table error_table(const std::vector<Case>& cases, const std::vector<Result>& results) {
  Table table({"loops", "formulation", "integrator", "settings", "step", "newton_tolerance",
               "iterations_per_step", "x_error", "order", "energy_drift", "position_residual",
               "velocity_residual", "acceleration_residual", "largest_tilt", "end", "status", "note"});
  const auto rough_figure = [](double value) { return fmt::format("{:.1e}", value); };
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Case& c = cases[k];
    const Result& r = results[k];
    table.add({std::to_string(c.loops), c.stepper.formulation, c.stepper.integrator, c.settings,
               fmt::format("{}", c.step), is_merged(c) ? fmt::format("{}", c.stepper.index3.tolerance) : "",
               fmt::format("{:.3f}", r.iterations), r.status == "ok" ? fmt::format("{:.3e}", r.x_error) : "",
               order(cases, results, k), fmt::format("{:.2e}", r.energy_drift),
               rough_figure(r.position_residual), rough_figure(r.velocity_residual),
               rough_figure(r.acceleration_residual), rough_figure(r.largest_tilt),
               fmt::format("{:.6g}", r.time), r.status, r.note});
  }
  return table;
}

namespace {

/// Roughly the time of a run on one core [s].
double cost_of(const Case& c) {
  const double n = 2.0 * c.loops + 2.0, steps = errors_end / c.step;
  const double ns = !is_merged(c)                       ? 1000.0
                    : c.stepper.index3.tolerance > fine ? 80.0
                                                        : 120.0 + 3.0 * std::min(c.loops, 100);
  return 1e-9 * ns * n * steps;
}

/// On all cores, as nothing is timed; the longest first.
std::vector<Result> run_cases(const std::vector<Case>& cases, const Tick& tick) {
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto cost = [&](std::size_t i) { return cost_of(cases[i]); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return cost(a) > cost(b); });
  Meter meter(std::transform_reduce(order.begin(), order.end(), 0.0, std::plus<>(), cost));
  std::vector<Result> results(cases.size());
  output::for_each_in_parallel(
      cases.size(), std::max(1U, std::thread::hardware_concurrency()),
      [&](std::size_t i) {
        results[order[i]] = four_bar::run(cases[order[i]], errors_end);
        meter.add(cost(order[i]));
      },
      [&](std::size_t) {
        tick(meter.share());
        return true;
      });
  return results;
}

/// Two loops over the first two passages of the flat position, each formulation with each integrator.
Table passages() {
  constexpr int loops = 2;
  constexpr double begin = 0.6, end = 1.35;  // [s]
  std::vector<double> exact_angles;          // by step
  for (int k = 0; k <= std::lround(end / step); ++k)
    exact_angles.push_back(k * step < begin ? 0.0 : four_bar::exact(loops, k * step).angle);
  Table table({"formulation", "integrator", "time", "exact_angle", "tilt", "angle_error"}, "passages");
  for (const mbs::StepperNames& names : mbs::stepper_names()) {
    const Case c = names.formulation == "index3" ? index3(loops, step, fine) : unmerged(loops, names, step);
    four_bar::run(c, end, [&](const four_bar::Place& place) {
      const double angle = exact_angles.at(std::lround(place.time / step));
      if (place.time < begin) return;
      table.add({names.formulation, names.integrator, fmt::format("{:.5f}", place.time),
                 fmt::format("{:.6f}", angle), fmt::format("{:.3e}", place.tilt),
                 fmt::format("{:.3e}", std::remainder(place.angle - angle, 2.0 * std::numbers::pi))});
    });
  }
  return table;
}

}  // namespace

std::vector<Table> linkage_errors(const Tick& tick) {
  const auto cases = error_cases();
  return {error_table(cases, run_cases(cases, tick)), passages()};
}

}  // namespace tandem::bench
