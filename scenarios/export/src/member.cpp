// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "member.hpp"

#include <fmt/format.h>

#include "system_description.hpp"
#include "tandem/coordinator/units.hpp"
#include "tandem/error.hpp"
#include "tandem/export/export.hpp"
#include "tandem/scenario/file_text.hpp"
#include "tandem/text/set.hpp"

namespace tandem::exported {
namespace {

namespace fs = std::filesystem;
using scenario::SubsystemEntry;

class MemberMaker {
 public:
  MemberMaker(const scenario::Scenario& of, const SubsystemEntry& entry, const SubsystemInfo& info,
              const SystemSettings& settings)
      : scenario_(of), entry_(entry), info_(info), settings_(settings), to_{entry.name, {}, {}} {
    to_.place = entry.source_place;
  }

  SystemMember make(const fs::path& folder, const Builtins& here) {
    const TimeSpan span{scenario_.start, scenario_.stop};
    const std::string scheme = entry_.scheme();
    if (entry_.isolated) to_.annotation["isolate"] = "true";
    if (const auto land = scenario_.coordination.landing.find(entry_.name);
        land != scenario_.coordination.landing.end() && land->second != Landing::automatic)
      to_.annotation["land"] = land->second == Landing::never ? "never" : "always";
    if (scheme == "fmu") return take_fmu(span.start), std::move(to_);
    if (scheme != "mechanism" && scheme != "diagram" && scheme != "scenario")
      scenario::refuse(
          entry_.source_place,
          fmt::format("subsystem '{}' is {}, which does not go along; allowed are mechanism:FILE, "
                      "diagram:FILE, scenario:FILE and fmu:FILE",
                      entry_.name, entry_.address()));
    export_source(scheme, span, folder, here);
    return std::move(to_);
  }

 private:
  /// Those of the scenario, and of the URI.
  std::map<std::string, Parameters::Value> parameters() const {
    std::map<std::string, Parameters::Value> all;
    for (const scenario::Parameter& p : entry_.parameters) all[p.name] = p.value;
    Parameters of_uri = query_of(entry_.source);
    for (const std::string& name : of_uri.names("")) all[name] = of_uri.text(name, "");
    return all;
  }

  std::map<std::string, double> starts(double t) const {
    std::map<std::string, double> all;
    for (const scenario::InputEntry& input : entry_.inputs)
      if (std::holds_alternative<double>(input.value))
        all[input.port] = input.at(t);
      else
        scenario::refuse(input.place,
                         fmt::format("input {}.{} is given over time, which a system has no words "
                                     "for; allowed is a number",
                                     entry_.name, input.port));
    return all;
  }

  void export_source(const std::string& scheme, const TimeSpan& span, const fs::path& folder,
                     const Builtins& here) {
    ExportSettings one{scheme + ":" + entry_.file().string(), entry_.overrides, folder / file_of(entry_.name),
                       settings_.version, settings_.library};
    one.member = Member{parameters(), starts(span.start), span};
    const std::string animated = "animate";
    if (scenario_.animate && scenario::takes(entry_, here, animated))
      one.member->parameters.try_emplace(animated, true);
    scenario::located(entry_.source_place, [&] { export_fmu(one, here); });
    take(one.file);
    to_.source = &info_;
    to_.annotation["lands"] = info_.abilities.lands ? "true" : "false";
  }

  void take(const fs::path& file) {
    to_.fmu = scenario::source_contents(file);
    to_.description = fmi::description_of(fmi::Archive(file), file);
  }

  void take_fmu(double start) {
    take(entry_.file());
    std::string outputs;
    for (const auto& [name, value] : parameters()) {
      const std::string text = std::visit([](const auto& one) { return fmt::format("{}", one); }, value);
      if (name.starts_with("set."))
        to_.values[name.substr(4)] = text;
      else if (name.starts_with("unit."))
        to_.units[name.substr(5)] = text;
      else if (name.starts_with("outputs."))
        outputs += text == "false" ? "" : (outputs.empty() ? "" : ", ") + text::toml_text(name.substr(8));
      else
        to_.annotation[name] = text;
    }
    if (!outputs.empty()) to_.annotation["outputs"] = "[" + outputs + "]";
    for (const auto& [port, value] : starts(start))
      to_.values[to_.variables(port, false).front()] = fmt::format("{}", value);
  }

  const scenario::Scenario& scenario_;
  const SubsystemEntry& entry_;
  const SubsystemInfo& info_;
  const SystemSettings& settings_;
  SystemMember to_;
};

/// The places of a port's scalars, or of one, among all; empty: there is no such port.
std::vector<int> places(const std::vector<Port>& ports, const std::string& name) {
  std::vector<int> all;
  int first = 0;
  for (const Port& port : ports) {
    for (int element = 0; element < port.size; ++element)
      if (port.name == name || Scalar{&port, element}.name() == name) all.push_back(first + element);
    first += port.size;
  }
  return all;
}

}  // namespace

std::vector<std::string> SystemMember::variables(const std::string& port, bool output) const {
  std::vector<std::string> all;
  const auto wanted = output ? fmi::Causality::output : fmi::Causality::input;
  if (!source) {
    for (const fmi::Variable& v : description.variables)
      if (fmi::port_name(v.name) == port) return {v.name};
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("'{}.{}' is an element of an array of an FMU; allowed are whole arrays", name, port));
  }
  for (const fmi::Variable& v : description.variables)
    if (v.causality == wanted) all.push_back(v.name);
  std::vector<std::string> found;
  for (const int k : places(output ? source->outputs : source->inputs, port))
    found.push_back(all.at(static_cast<std::size_t>(k)));
  return found;
}

/// One that has no base units goes unsaid, and that of the FMU holds.
std::string SystemMember::unit_of(const std::string& variable) const {
  const auto other = units.find(variable);
  if (other != units.end() && base_unit(other->second)) return other->second;
  for (const fmi::Variable& v : description.variables)
    if (v.name == variable) return v.unit;
  return "";
}

SystemMember member_of(const scenario::Scenario& scenario, const scenario::Parts& parts, int k,
                       const SystemSettings& settings, const fs::path& folder, const Builtins& here) {
  const SubsystemEntry& entry = scenario.subsystems.at(static_cast<std::size_t>(k));
  return MemberMaker(scenario, entry, parts.topology().info(k), settings).make(folder, here);
}

}  // namespace tandem::exported
