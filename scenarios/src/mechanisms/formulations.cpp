// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/formulations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::mechanisms {
namespace {

struct Figures {
  double error, drift;
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
  for (int k = 1; k <= steps; ++k) {
    stepper->step(s, h, h * k);
    kinetic = std::max(kinetic, m.kinetic(s.v.data()));
  }
  return {c.example->error(m, s), (balance(m, s) - before) / kinetic, mbs::residuals(m, s)};
}

/// One cell: no commas.
std::string cell(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), ',', ';');
  return sentence;
}

}  // namespace

std::vector<FormulationCase> formulation_cases() {
  std::vector<FormulationCase> all;
  for (const Example& example : examples())
    for (const mbs::StepperNames& names : mbs::stepper_names())
      all.push_back({&example, names, example.steps});
  return all;
}

FormulationRow formulation_row(const FormulationCase& c, const std::filesystem::path& mechanisms) {
  const auto file = mechanisms / c.example->name / (c.example->name + ".toml");
  const std::string key = fmt::format("{},{},{},{:.6g},", c.example->name, c.names.formulation,
                                      c.names.integrator, c.example->end / (2 * c.steps));
  try {
    const Figures coarse = run(c, file, c.steps), fine = run(c, file, 2 * c.steps);
    return {key + fmt::format("{:.2f},{:.2e},{:.1e},{:.1e},{:.1e},ok", std::log2(coarse.error / fine.error),
                              fine.drift, fine.residuals.position, fine.residuals.velocity,
                              fine.residuals.acceleration),
            key + fmt::format("{:.3e},", fine.error)};
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    return {key + ",,,,,failed", key + "," + cell(error.what())};
  }
}

}  // namespace tandem::mechanisms
