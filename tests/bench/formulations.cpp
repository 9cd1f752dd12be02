// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Every formulation with each integrator on every example mechanism.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <thread>

#include "bench/bench.hpp"
#include "mechanisms/examples.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"
#include "tandem/output/parallel.hpp"

namespace tandem::bench {
namespace {

/// One formulation and integrator on one mechanism, with that many steps.
struct FormulationCase {
  const mechanisms::Example* example;
  mbs::StepperNames names;
  int steps;
};

struct Figures {
  double error, drift, seconds;  ///< seconds: of processor time
  mbs::Residuals residuals;
};

/// Energy less the work of constant forces on relative coordinates.
double balance(const mbs::Mechanism& m, const mbs::State& s) {
  double sum = m.energy(s.q.data(), s.v.data());
  for (const mbs::Force& f : m.description().forces)
    if (f.kind == mbs::Force::Kind::relative)
      sum -= f.gain * m.inputs()[static_cast<std::size_t>(f.input)].value *
             s.q[m.numbering().relative[static_cast<std::size_t>(f.index)]];
  return sum;
}

Figures run(const FormulationCase& c, int steps) {
  const std::string& name = c.example->name;
  mbs::Mechanism m(
      mbs::read_mechanism(std::filesystem::path("scenarios/mechanisms") / name / (name + ".toml")));
  mbs::StepperSettings settings;
  settings.formulation = c.names.formulation;
  settings.integrator = c.names.integrator;
  const auto stepper = mbs::make_stepper(m, settings);
  mbs::State s = mbs::initial_state(m, 0.0);
  stepper->start(s);
  const double h = c.example->end / steps, before = balance(m, s);
  double kinetic = m.kinetic(s.v.data());
  const std::clock_t began = std::clock();
  for (int k = 1; k <= steps; ++k) {
    stepper->step(s, h, h * k);
    kinetic = std::max(kinetic, m.kinetic(s.v.data()));
  }
  const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  return {c.example->error(m, s), (balance(m, s) - before) / kinetic, seconds, mbs::residuals(m, s)};
}

std::vector<std::string> key_of(const FormulationCase& c, int steps) {
  return {c.example->name, c.names.formulation, c.names.integrator,
          fmt::format("{:.6g}", c.example->end / steps)};
}

/// Without order where half the step gains less than its integrator's: what is left is another error.
const char* status(const FormulationCase& c, double order) {
  const std::string& integrator = c.names.integrator;
  const double expected = integrator == "rk8" ? 8.0 : integrator == "rk4" ? 4.0 : 2.0;
  return order > expected - 0.5 ? "ok" : "no order";
}

/// One cell: no commas.
std::string cell(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), ',', ';');
  return sentence;
}

/// Every pair on every example, at its own number of steps. rk8 takes longer ones: with those of the others
/// its errors are rounding.
std::vector<FormulationCase> formulation_cases() {
  std::vector<FormulationCase> all;
  for (const mechanisms::Example& example : mechanisms::examples())
    for (const mbs::StepperNames& names : mbs::stepper_names())
      all.push_back({&example, names, names.integrator == "rk8" ? example.steps / 16 : example.steps});
  return all;
}

/// Cells of a row; `cells` are those after the key.
std::vector<std::string> row(const FormulationCase& c, int steps, const std::vector<std::string>& cells) {
  auto all = key_of(c, steps);
  all.insert(all.end(), cells.begin(), cells.end());
  return all;
}

/// Of the finer of two runs; order: log2 of the ratio of their errors.
std::vector<std::string> formulation_row(const FormulationCase& c) {
  try {
    const Figures coarse = run(c, c.steps), fine = run(c, 2 * c.steps);
    const double order = std::log2(coarse.error / fine.error);
    const mbs::Residuals& r = fine.residuals;
    return row(
        c, 2 * c.steps,
        {fmt::format("{:.3e}", fine.error), fmt::format("{:.2f}", order), fmt::format("{:.2e}", fine.drift),
         fmt::format("{:.1e}", r.position), fmt::format("{:.1e}", r.velocity),
         fmt::format("{:.1e}", r.acceleration), status(c, order), ""});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    return row(c, 2 * c.steps, {"", "", "", "", "", "", "failed", cell(error.what())});
  }
}

/// The least time of several runs.
std::vector<std::string> work_row(const FormulationCase& c) {
  constexpr double patience = 0.03;  // [s]
  constexpr int most = 5;
  try {
    Figures best = run(c, c.steps);
    double spent = best.seconds;
    for (int k = 1; k < most && spent < patience; ++k) {
      const Figures again = run(c, c.steps);
      spent += again.seconds;
      best.seconds = std::min(best.seconds, again.seconds);
    }
    return row(c, c.steps, {fmt::format("{:.3e}", best.error), fmt::format("{:.3e}", best.seconds), "ok"});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    return row(c, c.steps, {"", "", "failed"});
  }
}

}  // namespace

Table formulations(const Tick& tick) {
  Table table({"mechanism", "formulation", "integrator", "step", "error", "order", "energy_drift",
               "position_residual", "velocity_residual", "acceleration_residual", "status", "note"});
  const auto cases = formulation_cases();
  std::vector<std::vector<std::string>> rows(cases.size());
  output::for_each_in_parallel(
      cases.size(), std::max(1U, std::thread::hardware_concurrency()),
      [&](std::size_t i) { rows[i] = formulation_row(cases[i]); },
      [&](std::size_t done) {
        tick(static_cast<double>(done) / static_cast<double>(cases.size()));
        return true;
      });
  for (auto& one : rows) table.add(std::move(one));
  return table;
}

Table mechanisms(const Tick& tick) {
  Table table({"mechanism", "formulation", "integrator", "step", "error", "seconds", "status"});
  const auto cases = formulation_cases();
  double done = 0.0;
  for (const FormulationCase& c : cases) {
    for (const int steps : {c.steps / 4, c.steps / 2, c.steps, 2 * c.steps})
      table.add(work_row({c.example, c.names, steps}));
    tick(++done / static_cast<double>(cases.size()));
  }
  return table;
}

}  // namespace tandem::bench
