// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/diagram.hpp"

#include "sources/run_table.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"
#include "tandem/error.hpp"

namespace tandem::diagrams {
namespace {

/// The diagram with the parameters that are given.
engine::Description read(const std::filesystem::path& file, Parameters& p) {
  engine::ParameterValues values;
  for (const engine::Parameter& parameter : engine::read_diagram(file).parameters)
    if (p.has(parameter.name)) values[parameter.name] = p.number(parameter.name, parameter.value);
  return engine::read_diagram(file, values);
}

void take(Parameters& p, engine::AdaptiveSettings& s) {
  s.relative_tolerance = p.number("relative_tolerance", s.relative_tolerance);
  s.absolute_tolerance = p.number("absolute_tolerance", s.absolute_tolerance);
  s.longest_step = p.number("longest_step", s.longest_step);
  s.most_steps = static_cast<long>(p.number("most_steps", static_cast<double>(s.most_steps)));
}

std::unique_ptr<Subsystem> make(const std::filesystem::path& file, Parameters& p) {
  take_run_table(text::Document(file), p);
  const engine::Description diagram = read(file, p);
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
  return engine::make_subsystem(diagram, settings);
}

}  // namespace

void add_sources(Builtins& builtins) { builtins.files["diagram"] = make; }

}  // namespace tandem::diagrams
