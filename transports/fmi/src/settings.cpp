// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "values.hpp"

namespace tandem::fmi {
namespace {

Kind kind_of(const Description& d, Parameters& p) {
  const std::string type = p.text("type", d.co_simulation ? "cs" : "me");
  if (type != "cs" && type != "me")
    refuse("parameter 'type' is '" + type + "'; allowed are cs (Co-Simulation) and me (Model Exchange)");
  const Kind kind = type == "cs" ? Kind::co_simulation : Kind::model_exchange;
  if (!(kind == Kind::co_simulation ? d.co_simulation : d.model_exchange))
    refuse("parameter 'type' is " + type + ", but the FMU '" + printable(d.name, 200) + "' does not offer " +
           name_of(kind));
  return kind;
}

bool asks_for_inputs(const Description& d) {
  return d.co_simulation->asks_for_inputs &&
         std::any_of(d.variables.begin(), d.variables.end(), [](const Variable& v) {
           return v.causality == Causality::input && v.intermediate && is_real(v.type) &&
                  v.variability == Variability::continuous;
         });
}

Held held_of(const Description& d, Parameters& p) {
  static const std::vector<std::string> words = {"mean",   "left",        "right",
                                                 "middle", "derivatives", "intermediate"};
  const std::string word = p.text("inputs", words[0]);
  const auto it = std::find(words.begin(), words.end(), word);
  if (it == words.end()) refuse("parameter 'inputs' is '" + word + "'; allowed are " + listed(words));
  const auto held = static_cast<Held>(it - words.begin());
  if (held == Held::derivatives && !d.co_simulation->interpolates_inputs)
    refuse("parameter 'inputs' is derivatives, but the FMU '" + printable(d.name, 200) +
           "' does not take any (canInterpolateInputs); allowed are mean, left, right, middle");
  if (held == Held::intermediate && !asks_for_inputs(d))
    refuse("parameter 'inputs' is intermediate, but the FMU '" + printable(d.name, 200) +
           "' has no input that it asks for within a step (providesIntermediateUpdate, and inputs with "
           "intermediateUpdate); allowed are mean, left, right, middle");
  return held;
}

/// 0: it has none.
/// The parameter, else the description's attribute; 0: there is neither.
double above_zero(Parameters& p, const std::string& name, std::optional<double> own,
                  const std::string& attribute) {
  if (!p.has(name) && own && !(*own > 0.0))
    refuse(
        fmt::format("{} of the FMU is {}; allowed is above 0, or the parameter {}", attribute, *own, name));
  return p.has(name) || own ? positive(p, name, own.value_or(0.0)) : 0.0;
}

double step_of(const Description& d, Kind kind, Parameters& p) {
  if (const auto inside = offer_of(d, kind).fixed_step)
    return above_zero(p, "step", inside, "fixedInternalStepSize");
  return above_zero(p, "step", d.experiment.step, "stepSize of DefaultExperiment");
}

std::vector<std::string> outputs_of(const Description& d, Parameters& p) {
  std::vector<std::string> all, known;
  for (const Variable& v : d.variables)
    if (is_number(v.type) && v.causality != Causality::input && !v.clocked) known.push_back(v.name);
  for (const std::string& name : p.names("outputs.")) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse_name("parameter outputs: variable", name, known);
    if (p.flag("outputs." + name, false)) all.push_back(name);
  }
  return all;
}

std::map<std::string, std::string> units_of(Parameters& p) {
  std::map<std::string, std::string> units;
  for (const std::string& name : p.names("unit.")) units[name] = p.text("unit." + name, "");
  return units;
}

/// How many derivatives of inputs are given: of a study that tries several ways, 0 where there are none.
int order_of(Held held, Parameters& p) {
  const bool gives = held == Held::derivatives;
  const double order = p.number("order", gives ? 1.0 : 0.0);
  if (gives ? order != 1.0 && order != 2.0 : order != 0.0)
    refuse("parameter 'order' is " + std::to_string(order) +
           (gives ? "; allowed are 1 and 2, derivatives of the inputs"
                  : " without inputs=derivatives; allowed is 0, or to leave it out"));
  return static_cast<int>(order);
}

/// Whether derivatives of outputs are taken from it.
bool derives_outputs(const Description& d, Parameters& p) {
  const double order = p.number("derivatives", 0.0);
  if (order != 0.0 && order != 1.0)
    refuse("parameter 'derivatives' is " + std::to_string(order) + "; allowed are 0 and 1");
  if (order == 1.0 && !d.co_simulation->derives_outputs)
    refuse("parameter 'derivatives' is 1, but the FMU '" + printable(d.name, 200) +
           "' gives no derivatives of outputs (maxOutputDerivativeOrder); allowed is 0");
  return order == 1.0;
}

}  // namespace

std::string name_of(Kind kind) { return kind == Kind::co_simulation ? "Co-Simulation" : "Model Exchange"; }

Words fmu_words() {
  return words_by(Setter::client, {"step", "set.*"}) +
         words_by(Setter::operator_only, {"type", "inputs", "order", "derivatives", "tolerance", "lands",
                                          "state", "log", "unit.*", "outputs.*"});
}

Settings take_settings(Description& d, Parameters& p, const FmuIntegrators& integrators) {
  Settings s;
  s.kind = kind_of(d, p);
  s.step = step_of(d, s.kind, p);
  s.logs = p.flag("log", false);
  if (const double t = above_zero(p, "tolerance", d.experiment.tolerance, "tolerance of DefaultExperiment");
      t > 0.0)
    s.tolerance = t;
  s.values = take_values(d, p);
  s.units = units_of(p);
  s.outputs = outputs_of(d, p);
  if (s.kind == Kind::model_exchange) {
    if (integrators.make) s.integrator = integrators.make(p);
    return s;
  }
  s.held = held_of(d, p);
  s.order = order_of(s.held, p);
  s.derives_outputs = derives_outputs(d, p);
  s.lands = p.flag("lands", d.co_simulation->varies_steps && !d.co_simulation->fixed_step);
  const std::string state = p.text("state", "off");
  if (state != "off" && state != "trust")
    refuse("parameter 'state' is '" + state +
           "'; allowed are off, and trust: the FMU's state is the whole of it");
  if (state == "trust" && !d.co_simulation->keeps_state)
    refuse("parameter 'state' is trust, but the FMU '" + printable(d.name, 200) +
           "' gives no state "
           "(canGetAndSetFMUstate)");
  s.trusts_state = state == "trust";
  return s;
}

}  // namespace tandem::fmi
