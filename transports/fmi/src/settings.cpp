// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

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

Held held_of(const Description& d, Parameters& p) {
  static const std::vector<std::string> words = {"mean", "left", "right", "middle", "derivatives"};
  const std::string word = p.text("inputs", words[0]);
  const auto it = std::find(words.begin(), words.end(), word);
  if (it == words.end()) refuse("parameter 'inputs' is '" + word + "'; allowed are " + listed(words));
  const auto held = static_cast<Held>(it - words.begin());
  if (held == Held::derivatives && !d.co_simulation->interpolates_inputs)
    refuse("parameter 'inputs' is derivatives, but the FMU '" + printable(d.name, 200) +
           "' does not take any (canInterpolateInputs); allowed are mean, left, right, middle");
  return held;
}

double step_of(const Description& d, Parameters& p) {
  if (!p.has("step") && !d.experiment.step)
    refuse("the FMU '" + printable(d.name, 200) +
           "' names no step of its own (DefaultExperiment stepSize); give the parameter step, a number above "
           "0 [s]");
  return positive(p, "step", d.experiment.step.value_or(0.0));
}

/// Variables that may be given a value before the start, by name.
std::map<std::string, int> settable(const Description& d) {
  std::map<std::string, int> all;
  for (int k = 0; k < std::ssize(d.variables); ++k) {
    const Variable& v = d.variables[static_cast<std::size_t>(k)];
    const bool allowed =
        v.causality == Causality::parameter || (v.start && v.variability != Variability::constant);
    if (allowed) all[v.name] = k;
  }
  return all;
}

[[noreturn]] void refuse_name(const std::string& what, const std::string& name,
                              std::vector<std::string> known) {
  constexpr std::size_t most = 30;
  if (known.size() <= most) refuse(unknown(what, printable(name, 200), known));
  const std::string near = nearest(name, known);
  refuse(what + " '" + printable(name, 200) + "' is not there" +
         (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

/// A number, or of a boolean true or false.
double number_of(const Variable& v, const std::string& word, Parameters& p) {
  const bool flag = v.type == Type::boolean;
  const double value = flag ? (p.flag(word, false) ? 1.0 : 0.0) : p.number(word, 0.0);
  if (v.type != Type::real && value != std::round(value))
    refuse("parameter '" + word + "' is " + std::to_string(value) + "; allowed is a whole number");
  if (!(value >= v.min && value <= v.max))
    refuse("parameter '" + word + "' is " + std::to_string(value) + "; allowed is a number from " +
           std::to_string(v.min) + " to " + std::to_string(v.max));
  return value;
}

std::vector<Setting> values_of(const Description& d, Parameters& p) {
  const auto all = settable(d);
  std::vector<Setting> values;
  for (const std::string& name : p.names("set.")) {
    const std::string word = "set." + name;
    const auto it = all.find(name);
    if (it == all.end()) {
      std::vector<std::string> known;
      for (const auto& [one, variable] : all) known.push_back(one);
      refuse_name("parameter set: variable", name, known);
    }
    const Variable& v = d.variables[static_cast<std::size_t>(it->second)];
    const bool text = v.type == Type::string;
    if (text && p.from_client(word))
      refuse("parameter '" + word +
             "' is a text that comes from a client; only who serves the source may set it");
    values.push_back({it->second, text ? 0.0 : number_of(v, word, p), text ? p.text(word, "") : ""});
  }
  return values;
}

std::map<std::string, std::string> units_of(Parameters& p) {
  std::map<std::string, std::string> units;
  for (const std::string& name : p.names("unit.")) units[name] = p.text("unit." + name, "");
  return units;
}

}  // namespace

std::string name_of(Kind kind) { return kind == Kind::co_simulation ? "Co-Simulation" : "Model Exchange"; }

Words fmu_words() {
  return words_by(Setter::client, {"step", "set.*"}) +
         words_by(Setter::operator_only,
                  {"type", "inputs", "order", "tolerance", "lands", "state", "log", "unit.*"});
}

Settings take_settings(const Description& d, Parameters& p) {
  Settings s;
  s.kind = kind_of(d, p);
  s.step = step_of(d, p);
  s.logs = p.flag("log", false);
  if (p.has("tolerance") || d.experiment.tolerance)
    s.tolerance = positive(p, "tolerance", d.experiment.tolerance.value_or(0.0));
  s.values = values_of(d, p);
  s.units = units_of(p);
  if (s.kind == Kind::model_exchange) return s;
  s.held = held_of(d, p);
  if (s.held == Held::derivatives) {
    const double order = p.number("order", 1.0);
    if (order != 1.0 && order != 2.0)
      refuse("parameter 'order' is " + std::to_string(order) +
             "; allowed are 1 and 2, derivatives of the inputs");
    s.order = static_cast<int>(order);
  }
  s.lands = p.flag("lands", false);
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
