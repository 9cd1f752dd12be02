// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/formulations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::mechanisms {
namespace {

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

Figures run(const FormulationCase& c, const std::filesystem::path& file, int steps) {
  mbs::Mechanism m(mbs::read_mechanism(file));
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

std::filesystem::path file_of(const FormulationCase& c, const std::filesystem::path& mechanisms) {
  return mechanisms / c.example->name / (c.example->name + ".toml");
}

std::string key_of(const FormulationCase& c, int steps) {
  return fmt::format("{},{},{},{:.6g},", c.example->name, c.names.formulation, c.names.integrator,
                     c.example->end / steps);
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

}  // namespace

/// rk8 takes longer steps: with those of the others its errors are rounding.
std::vector<FormulationCase> formulation_cases() {
  std::vector<FormulationCase> all;
  for (const Example& example : examples())
    for (const mbs::StepperNames& names : mbs::stepper_names())
      all.push_back({&example, names, names.integrator == "rk8" ? example.steps / 16 : example.steps});
  return all;
}

FormulationRow formulation_row(const FormulationCase& c, const std::filesystem::path& mechanisms) {
  const auto file = file_of(c, mechanisms);
  const std::string key = key_of(c, 2 * c.steps);
  try {
    const Figures coarse = run(c, file, c.steps), fine = run(c, file, 2 * c.steps);
    const double order = std::log2(coarse.error / fine.error);
    return {
        key + fmt::format("{:.2f},{:.2e},{:.1e},{:.1e},{:.1e},{}", order, fine.drift, fine.residuals.position,
                          fine.residuals.velocity, fine.residuals.acceleration, status(c, order)),
        key + fmt::format("{:.3e},", fine.error)};
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    return {key + ",,,,,failed", key + "," + cell(error.what())};
  }
}

std::vector<FormulationCase> work_cases() {
  std::vector<FormulationCase> all;
  for (const FormulationCase& c : formulation_cases())
    for (const int steps : {c.steps / 4, c.steps / 2, c.steps, 2 * c.steps})
      all.push_back({c.example, c.names, steps});
  return all;
}

std::string work_row(const FormulationCase& c, const std::filesystem::path& mechanisms) {
  constexpr double patience = 0.03;  // [s]
  constexpr int most = 5;
  try {
    Figures best = run(c, file_of(c, mechanisms), c.steps);
    double spent = best.seconds;
    for (int k = 1; k < most && spent < patience; ++k) {
      const Figures again = run(c, file_of(c, mechanisms), c.steps);
      spent += again.seconds;
      best.seconds = std::min(best.seconds, again.seconds);
    }
    return key_of(c, c.steps) + fmt::format("{:.3e},{:.3e},ok", best.error, best.seconds);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    return key_of(c, c.steps) + ",,failed";
  }
}

}  // namespace tandem::mechanisms
