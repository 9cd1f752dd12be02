// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/nested.hpp"

#include <algorithm>
#include <set>

#include "nested_run.hpp"
#include "nesting.hpp"
#include "tandem/scenario/scenario_file.hpp"
#include "tandem/sources/file_parameters.hpp"
#include "tandem/text/set.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem::scenario {
namespace {

constexpr const char* own_step = "step";

/// A parameter, and the key of the scenario that sets it.
struct Settable {
  text::FileParameter parameter;
  std::string key;
};

std::vector<text::FileParameter> of_member(const SubsystemEntry& entry) {
  Parameters given;
  for (const Parameter& p : entry.parameters) given.set(p.name, p.value);
  return parameters_of(entry.source, std::filesystem::path(entry.place.file).parent_path(), entry.overrides,
                       given);
}

/// Neither made of constants nor said in the URI.
bool is_free(const SubsystemEntry& entry, const std::string& name) {
  const bool refers = std::any_of(entry.parameters.begin(), entry.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name && p.refers; });
  return !refers && !query_of(entry.source).has(name);
}

/// As a parameter of a member is given already, or else could be.
std::string key_of(const SubsystemEntry& entry, const std::string& name) {
  for (const Parameter& p : entry.parameters)
    if (p.name == name && !p.key.empty()) return p.key;
  return "subsystems." + entry.name + ".parameters." + text::toml_text(name);
}

void refuse_twice(const Scenario& scenario, const std::vector<Settable>& all) {
  std::set<std::string> names;
  for (const auto& [parameter, key] : all)
    if (!names.insert(parameter.name).second)
      refuse({scenario.file.string()},
             "constant '" + parameter.name +
                 "' has the name of a parameter of a member; of a scenario that is one "
                 "subsystem allowed is a name of its own");
}

/// But for names that no key can have, and that of the setting.
std::vector<Settable> settable(const Scenario& scenario) {
  std::vector<Settable> all;
  const auto add = [&](text::FileParameter p, std::string key) {
    if (p.name != own_step && p.name.find_first_of("\"\\\n") == std::string::npos)
      all.push_back({std::move(p), std::move(key)});
  };
  for (const auto& [name, value] : scenario.constants)
    add({name, "", value, {scenario.file.string()}}, "constants." + text::toml_text(name));
  for (const SubsystemEntry& entry : scenario.subsystems)
    for (text::FileParameter& p : text::located(entry.source_place, [&] { return of_member(entry); })) {
      if (!is_free(entry, p.name)) continue;
      std::string key = key_of(entry, p.name);
      p.name = entry.name + "." + p.name;
      add(std::move(p), std::move(key));
    }
  refuse_twice(scenario, all);
  return all;
}

/// The scenario with the values that are given of what may be set.
Scenario with_given(const ScenarioFile& file, Parameters& given) {
  const Scenario as_it_is = file.with({});
  check_nesting(as_it_is);
  std::vector<Setting> settings;
  for (const auto& [parameter, key] : settable(as_it_is)) {
    const auto* number = std::get_if<double>(&parameter.value);
    const bool open = number || !parameter.allowed.empty();  // a word may name a file
    given.declare({{parameter.name, open ? Setter::client : Setter::operator_only}});
    text::SetValue value;
    if (number)
      value = given.number(parameter.name, *number);
    else
      value = given.text(parameter.name, std::get<std::string>(parameter.value));
    if (given.has(parameter.name)) settings.push_back({key, std::move(value)});
  }
  return settings.empty() ? as_it_is : file.with(settings);
}

}  // namespace

std::vector<text::FileParameter> parameters_of(const std::string& source, const std::filesystem::path& folder,
                                               const std::vector<std::string>& overrides, Parameters& given) {
  const SourceUri uri(source);
  const auto file = folder / uri.place;
  if (uri.scheme == "mechanism" || uri.scheme == "diagram") {
    text::Document document(file);
    document.set(overrides);
    return text::parameters_of(document, take_file_parameters(document, {}, given));
  }
  std::vector<text::FileParameter> all;
  if (uri.scheme != nested_scheme) return all;
  for (Settable& one : settable(with_given(ScenarioFile(file, overrides), given)))
    all.push_back(std::move(one.parameter));
  return all;
}

Source nested_source(Builtins members) {
  const Words words = words_by(Setter::client, {own_step});
  return {
      words,
      [members = std::move(members)](const Address& address, Parameters& p) -> std::unique_ptr<Subsystem> {
        Builtins all = members;
        all.schemes[nested_scheme] = nested_source(members);
        const double step = positive(p, own_step, 1.0);
        auto run = std::make_shared<NestedRun>(with_given(ScenarioFile(address.file(), address.overrides), p),
                                               all, p.has(own_step) ? step : 0.0);
        return std::make_unique<FixedStep<NestedModel>>(NestedModel(std::move(run)));
      }};
}

void add_nested(Builtins& all) {
  Builtins members;
  for (const char* scheme : {"mechanism", "diagram"}) members.schemes[scheme] = all.schemes.at(scheme);
  all.schemes[nested_scheme] = nested_source(std::move(members));
}

}  // namespace tandem::scenario
