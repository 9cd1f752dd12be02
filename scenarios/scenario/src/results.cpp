// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "tandem/output/files.hpp"
#include "tandem/output/provenance.hpp"

namespace tandem::scenario {
namespace {
using Json = nlohmann::ordered_json;

Json scenario_of(const Scenario& scenario) {
  return {{"file", scenario.file.string()},
          {"name", scenario.name},
          {"overrides", scenario.overrides},
          {"taken", scenario.taken},
          {"values", Json::parse(scenario.values)}};
}

Json coordination_of(const Assembly& assembly) {
  const Coordinator& run = assembly.coordinator();
  Json order = Json::array(), steps = Json::object();
  for (const int i : run.schedule().order()) order.push_back(run.topology().name(i));
  for (int i = 0; i < run.topology().size(); ++i) steps[run.topology().name(i)] = run.own_step(i);
  return {{"schedule", Schedule::name(run.schedule().kind())},
          {"leader_first", order},
          {"start", name(run.start())},
          {"passes_of_the_start", run.start_passes()},
          {"first_own_steps", steps}};
}

Json reached(const Assembly& assembly) {
  Json times = Json::object();
  for (int i = 0; i < assembly.topology().size(); ++i)
    times[assembly.topology().name(i)] = assembly.coordinator().time(i);
  return times;
}

}  // namespace

Json results_of(const Scenario& scenario, const Assembly& assembly, const Recorder& recorder,
                const RunEnd& end) {
  Json units{{"time", "s"}}, interpolation = Json::object(), files = Json::array(), notes = Json::array();
  for (const auto& column : recorder.columns()) {
    units[column.name] = column.unit;
    interpolation[column.name] = Recorder::name(column.fill);
  }
  for (const auto& file : recorder.files()) files.push_back(file.filename().string());
  for (const auto& note : assembly.notes()) notes.push_back(note);
  for (const auto& note : recorder.notes()) notes.push_back(note);
  return {{"status", end.status},
          {"message", end.message},
          {"notes", notes},
          {"files", files},
          {"units", units},
          {"interpolation", interpolation},
          {"coordination", coordination_of(assembly)},
          {"stands_at", reached(assembly)},
          {"versions",
           {{"tandem", output::version()},
            {"commit", output::source_commit()},
            {"compiler", output::compiler()}}},
          {"scenario", scenario_of(scenario)}};
}

Json machine_figures(const Assembly& assembly, const RunEnd& end, const RunSettings& settings,
                     double simulated) {
  Json subsystems = Json::object();
  double inside = 0.0;
  for (int i = 0; i < assembly.topology().size(); ++i) {
    const Effort& effort = assembly.coordinator().effort(i);
    Json& figures = subsystems[assembly.topology().name(i)];
    figures = {{"steps", effort.steps}, {"exchanges", effort.exchanges}};
    if (effort.start_steps > 0) figures["steps_of_the_start"] = effort.start_steps;
    if (settings.profile) figures["seconds"] = effort.seconds;
    for (const Figure& figure : assembly.subsystem(i).figures())
      figures["integrator"][figure.name] = figure.count;
    inside += effort.seconds;
  }
  Json json{{"processor", output::processor_model()},
            {"simulated_seconds", simulated},
            {"seconds", end.seconds},
            {"real_time_factor", end.seconds > 0.0 ? Json(simulated / end.seconds) : Json()},
            {"subsystems", subsystems}};
  if (settings.expectation) json["seconds_of_the_estimate"] = settings.expectation->seconds;
  if (settings.profile) json["coordinator"] = {{"seconds", end.seconds - inside}};
  return json;
}

void write_json(const std::filesystem::path& file, const Json& json) {
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  output::replace_durably(file, std::as_bytes(std::span(text)));
}

}  // namespace tandem::scenario
