// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/make_stepper.hpp"

#include <algorithm>

#include "scaled.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/formulations/unmerged.hpp"
#include "tandem/mbs/integrators/runge_kutta.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

[[noreturn]] void refuse_choice(const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, sentence);
}

struct FormulationEntry {
  std::string name;
  std::unique_ptr<Formulation> (*make)(Model&, const StepperSettings&);
};

/// Every formulation that runs with any integrator.
const std::vector<FormulationEntry>& formulations() {
  using S = StepperSettings;
  using P = std::unique_ptr<Formulation>;
  static const std::vector<FormulationEntry> all = {
      {"penalty", [](Model& m, const S& s) -> P { return std::make_unique<Penalty>(m, s.penalty); }},
      {"index1", [](Model& m, const S& s) -> P { return std::make_unique<Index1>(m, s.index1); }},
      {"null_space", [](Model& m, const S& s) -> P { return std::make_unique<NullSpace>(m, s.null_space); }}};
  return all;
}

struct IntegratorEntry {
  std::string name;
  std::unique_ptr<Integrator> (*make)(const StepperSettings&);
};

/// Every integrator.
const std::vector<IntegratorEntry>& integrators() {
  using S = StepperSettings;
  using P = std::unique_ptr<Integrator>;
  static const std::vector<IntegratorEntry> all = {
      {"newmark", [](const S& s) -> P { return std::make_unique<NewmarkFamily>(s.newmark); }},
      {"rk2", [](const S&) -> P { return std::make_unique<RungeKutta>(midpoint_rule()); }},
      {"rk4", [](const S&) -> P { return std::make_unique<RungeKutta>(classical_runge_kutta()); }},
      {"rk8", [](const S&) -> P { return std::make_unique<RungeKutta>(dormand_prince8()); }},
      {"generalized_alpha",
       [](const S& s) -> P { return std::make_unique<NewmarkFamily>(s.generalized_alpha); }}};
  return all;
}

template <class Entry>
const Entry& find(const std::string& kind, const std::string& name, const std::vector<Entry>& entries,
                  std::vector<std::string> known = {}) {
  for (const Entry& entry : entries)
    if (entry.name == name) return entry;
  for (const Entry& entry : entries) known.push_back(entry.name);
  refuse_choice(unknown(kind, name, known));
}

/// Settings of what is not chosen would be lost in silence.
template <class Settings>
void refuse_unused(const Settings& settings, const char* name, bool used) {
  if (!used && settings != Settings{})
    refuse_choice(std::string("settings of ") + name +
                  " are given, which is not chosen; allowed is to leave them out");
}

void refuse_unused(const StepperSettings& s) {
  const bool merged = s.formulation == "index3";
  refuse_unused(s.index3, "index3", merged);
  refuse_unused(s.penalty, "penalty", s.formulation == "penalty");
  refuse_unused(s.index1, "index1", s.formulation == "index1");
  refuse_unused(s.null_space, "null_space", s.formulation == "null_space");
  refuse_unused(s.generalized_alpha, "generalized_alpha", s.integrator == "generalized_alpha");
  if (merged && s.newmark != NewmarkSettings{})
    refuse_choice(
        "settings of newmark are given, which index3 has merged in; allowed is index3.beta and "
        "index3.tolerance");
  refuse_unused(s.newmark, "newmark", s.integrator == "newmark");
}

}  // namespace

std::vector<StepperNames> stepper_names() {
  std::vector<StepperNames> all = {{"index3", "newmark"}};
  for (const auto& formulation : formulations())
    for (const auto& integrator : integrators()) all.push_back({formulation.name, integrator.name});
  return all;
}

std::unique_ptr<Stepper> make_stepper(Model& model, const StepperSettings& s) {
  const bool merged = s.formulation == "index3";
  const auto* formulation =
      merged ? nullptr : &find("formulation", s.formulation, formulations(), {"index3"});
  const auto& integrator = find("integrator", s.integrator, integrators());
  if (merged && s.integrator != "newmark")
    refuse_choice("formulation index3 has Newmark's method merged in and does not go with integrator '" +
                  s.integrator +
                  "'; allowed is newmark, or formulation penalty, index1 or null_space with it");
  refuse_unused(s);
  if (!model.structure().coordinate_scales.empty())
    return std::make_unique<ScaledStepper>(model, [&s](Model& scaled) { return make_stepper(scaled, s); });
  if (merged) return std::make_unique<Index3>(model, s.index3);
  return std::make_unique<Unmerged>(formulation->make(model, s), integrator.make(s));
}

}  // namespace tandem::mbs
