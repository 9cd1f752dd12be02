// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/diagram.hpp"

#include "engine_models/compiled.hpp"
#include "sources/run_table.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"
#include "tandem/error.hpp"

namespace tandem::diagrams {
namespace {

engine::ParameterValue value(Parameters& p, const engine::Parameter& parameter) {
  if (const auto* number = std::get_if<double>(&parameter.value)) return p.number(parameter.name, *number);
  return p.text(parameter.name, std::get<std::string>(parameter.value));
}

/// The diagram with the parameters that are given.
engine::Description read(const std::filesystem::path& file, Parameters& p) {
  engine::ParameterValues values;
  for (const engine::Parameter& parameter : engine::read_diagram(file).parameters)
    if (p.has(parameter.name)) values[parameter.name] = value(p, parameter);
  return engine::read_diagram(file, values);
}

/// Inputs for which there is a parameter data.NAME, "FILE" or "FILE:COLUMN": a column of a CSV file, of the
/// input's name if none is given.
void take_data(engine::Description& d, Parameters& p) {
  std::vector<engine::Input> others;
  for (engine::Input& input : d.inputs) {
    const std::string data = p.text("data." + input.name, "");
    if (data.empty()) {
      others.push_back(std::move(input));
      continue;
    }
    const auto colon = data.find(':');
    const std::string column = colon == std::string::npos ? input.name : data.substr(colon + 1);
    d.blocks.push_back(
        {input.name, "csv", {{"file", data.substr(0, colon)}, {"column", column}}, input.where});
  }
  d.inputs = std::move(others);
}

void take(Parameters& p, engine::AdaptiveSettings& s) {
  s.relative_tolerance = p.number("relative_tolerance", s.relative_tolerance);
  s.absolute_tolerance = p.number("absolute_tolerance", s.absolute_tolerance);
  s.longest_step = p.number("longest_step", s.longest_step);
  s.shortest_step = p.number("shortest_step", s.shortest_step);
  s.most_steps = static_cast<long>(p.number("most_steps", static_cast<double>(s.most_steps)));
}

std::unique_ptr<Subsystem> make(const std::filesystem::path& file, Parameters& p, const Tell& tell) {
  take_run_table(text::Document(file), p);
  engine::Description diagram = read(file, p);
  take_data(diagram, p);
  diagram.kinds = engine_models::compiled_kinds();
  if (!p.has("step"))
    throw Error(
        ErrorCode::invalid_argument,
        "diagram '" + diagram.name +
            "' has no own step; give the parameter step, a number above 0 [s], or step in the table [run] "
            "of its file");
  engine::SubsystemSettings settings;
  settings.step = p.number("step", 0.0);
  settings.integrator.name = p.text("integrator", settings.integrator.name);
  settings.integrator.locate_events = p.flag("locate_events", settings.integrator.locate_events);
  take(p, settings.integrator.adaptive);
  if (tell)
    settings.simulation.tell = [tell, name = diagram.name](const std::string& text) {
      tell("diagram '" + name + "': " + text);
    };
  return engine::make_subsystem(diagram, settings);
}

}  // namespace

void add_sources(Builtins& builtins, const Tell& tell) {
  builtins.files["diagram"] = [tell](const std::filesystem::path& file, Parameters& p) {
    return make(file, p, tell);
  };
}

}  // namespace tandem::diagrams
