// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/diagram_info.hpp"

#include <fmt/format.h>

#include <set>

#include "cli/check_run.hpp"
#include "cli/print_parameter.hpp"
#include "cli/say.hpp"
#include "engine_models/compiled.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/text/document.hpp"

namespace tandem::cli {
namespace {

/// Events by block, each block once.
std::vector<std::string> event_blocks(const engine::Program& program) {
  std::set<std::string> names;
  for (const auto& crossing : program.crossings) names.insert(crossing.name);
  for (const auto& periodic : program.periodics) names.insert(periodic.name);
  return {names.begin(), names.end()};
}

const char* course(const engine::Course& course) {
  return course.held ? "; held" : course.jumps ? "; events may make it jump" : "";
}

std::vector<std::string> inputs_of(const engine::Description& diagram, const engine::Program& program,
                                   int output) {
  std::vector<std::string> names;
  for (const auto& [to, from] : program.feedthrough)
    if (to == output) names.push_back(diagram.inputs[static_cast<std::size_t>(from)].name);
  return names;
}

const char* word_of(engine::Limit::OnLeaving what) {
  using enum engine::Limit::OnLeaving;
  return what == ignore ? "ignored" : what == warn ? "told once" : "ends the run";
}

}  // namespace

bool is_diagram(const std::filesystem::path& file) { return scenario::kind_alone(file) == "diagram"; }

void print_diagram(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                   const Builtins& builtins) {
  Parameters none;
  engine::Description diagram = describe_diagram({file, {}, overrides}, none);
  diagram.kinds = engine_models::compiled_kinds();
  const engine::Program program = engine::compile(diagram);
  say("{}: a diagram of {} blocks, {} operations\n", diagram.name, diagram.blocks.size(),
      program.operations.size());
  say("  order {}: {}\n", program.states, listed(program.state_names));
  if (program.sampled())
    say("  sampled, its instants {} s or more apart: it takes no step\n", program.shortest_period);
  for (const auto& p : diagram.parameters) print_parameter(p);
  for (const auto& limit : diagram.limits)
    say("  limit {}: {} to {}, {}: {}\n", limit.name, limit.low, limit.high, word_of(limit.on_leaving),
        limit.sentence);
  for (const auto& input : diagram.inputs) say("  input {} [{}]\n", input.name, input.unit);
  for (std::size_t k = 0; k < diagram.outputs.size(); ++k)
    say("  output {} [{}], follows at once: {}{}\n", diagram.outputs[k].name, diagram.outputs[k].unit,
        listed(inputs_of(diagram, program, static_cast<int>(k))), course(program.courses[k]));
  say("  {} signals watched for events; periodic events: {}; of the blocks {}\n", program.crossings.size(),
      program.periodics.size(), listed(event_blocks(program)));
  for (const std::string& block : program.left_out)
    say("  block '{}' feeds no output and is left out\n", block);
  text::Document document(file);
  document.set(overrides);
  check_run(document, overrides, builtins);
}

}  // namespace tandem::cli
