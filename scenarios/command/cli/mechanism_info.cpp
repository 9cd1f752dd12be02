// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/mechanism_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/check_run.hpp"
#include "cli/print_parameter.hpp"
#include "cli/say.hpp"
#include "sources/elements.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/tangent.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/text/document.hpp"

namespace tandem::cli {
namespace {

/// Names of the variables, and of those of first order, which are states of elements.
std::pair<std::vector<std::string>, std::vector<std::string>> coordinates_and_states(
    const mbs::Structure& s) {
  std::vector<std::string> coordinates, states;
  for (int k = 0; k < s.variables; ++k) {
    const bool state = std::find(s.states.begin(), s.states.end(), k) != s.states.end();
    (state ? states : coordinates).push_back(s.variable_names[static_cast<std::size_t>(k)]);
  }
  return {coordinates, states};
}

void print_size(const mbs::Mechanism& mechanism) {
  const mbs::Description& in = mechanism.description();
  const mbs::Structure& s = mechanism.structure();
  const auto [coordinates, states] = coordinates_and_states(s);
  say("{}: a mechanism in {}\n", in.name, in.dimension == 2 ? "the plane" : "space");
  for (const mbs::Parameter& p : in.parameters) print_parameter(p);
  say("  {} bodies, {} points and vectors\n", in.bodies.size(), in.entities.size());
  say("  {} variables: {}\n", coordinates.size(), listed(coordinates));
  if (!states.empty()) say("  {} states of elements: {}\n", states.size(), listed(states));
  say("  {} constraints: {}\n", s.constraints, listed(s.constraint_names));
}

/// An equation that is off where the assembly comes nearest is not redundant, whatever its gradient.
void print_freedom(mbs::Mechanism& mechanism, const mbs::Assembled& found) {
  const mbs::Structure& s = mechanism.structure();
  const mbs::Freedom freedom = mbs::freedom(mechanism, found.state);
  const auto name = [&](int c) { return s.constraint_names[static_cast<std::size_t>(c)]; };
  std::vector<std::string> redundant, contradictory;
  for (const mbs::Contradiction& c : found.contradictions)
    contradictory.push_back(
        fmt::format("{} (off by {:.3g}{})", name(c.constraint), std::abs(c.off), s.unit_of(c.constraint)));
  for (const int c : freedom.redundant)
    if (std::none_of(found.contradictions.begin(), found.contradictions.end(),
                     [c](const mbs::Contradiction& other) { return other.constraint == c; }))
      redundant.push_back(name(c));
  say("  {} degrees of freedom {}\n", freedom.degrees - static_cast<int>(s.states.size()),
      contradictory.empty() ? "as assembled" : "where the assembly comes nearest");
  say("  redundant equations: {}\n", listed(redundant));
  if (!contradictory.empty()) say("  contradictory equations: {}\n", listed(contradictory));
}

void print_limits(const mbs::Description& in) {
  constexpr const char* words[] = {"ignore", "warn", "stop"};
  for (const mbs::Limit& limit : in.limits)
    say("  limit {}: {} to {}, {}: {}\n", limit.name, limit.low, limit.high,
        words[static_cast<int>(limit.on_leaving)], limit.sentence);
}

void print_tangent(const mbs::Structure& s) {
  const mbs::Tangent tangent(s, mbs::make_solver("auto", mbs::MatrixKind::positive_definite));
  const double n = s.variables;
  say("  tangent matrix: {} entries, {:.3g} % of it, {:.3g} a row\n", tangent.pattern().size(),
      100.0 * tangent.pattern().size() / (n * n), tangent.pattern().size() / n);
}

/// What stands or pulls where it starts: lengths, and outputs but for those that need accelerations.
void print_start(mbs::Mechanism& mechanism, double start) {
  const mbs::State s = mbs::initial_state(mechanism, start);
  const mbs::Description& in = mechanism.description();
  if (!in.equilibrium) return;
  say("  in equilibrium at the start:\n");
  for (std::size_t r = 0; r < in.relatives.size(); ++r)
    if (in.relatives[r].kind == mbs::Relative::Kind::length)
      say("    length {} = {:.6g} m\n", in.relatives[r].name, s.q[mechanism.numbering().relative[r]]);
  mbs::Outputs outputs(mechanism);
  std::vector<double> values(static_cast<std::size_t>(outputs.size()));
  outputs.evaluate(s, values.data());
  for (int k = 0; k < outputs.size(); ++k)
    if (in.outputs[static_cast<std::size_t>(k)].kind == mbs::Output::Kind::quantity)
      say("    {} = {:.6g} {}\n", outputs.name(k), values[static_cast<std::size_t>(k)], outputs.unit(k));
}

}  // namespace

std::string take_unknown_inputs_as_zero(mbs::Description& description) {
  std::vector<std::string> names;
  for (mbs::Input& input : description.inputs) {
    if (input.function || !std::isnan(input.value)) continue;
    input.value = 0.0;
    names.push_back(input.name);
  }
  return names.empty() ? "" : fmt::format("  inputs that are not known are taken as 0: {}\n", listed(names));
}

double start_of(const text::Document& mechanism) {
  return mechanism.table()["run"]["start"].value<double>().value_or(0.0);
}

bool is_mechanism(const std::filesystem::path& file) { return scenario::kind_alone(file) == "mechanism"; }

void print_mechanism(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const Builtins& builtins) {
  text::Document document(file);
  document.set(overrides);
  Parameters none;
  mbs::Description description = describe_mechanism({file, {}, overrides}, none, element_kinds());
  const std::string told = take_unknown_inputs_as_zero(description);
  mbs::Mechanism mechanism(description);
  const double start = start_of(document);
  const text::Place whole{file.string()};
  const auto found = text::located(whole, [&] { return mbs::assembled(mechanism, start); });
  print_size(mechanism);
  say("{}", told);
  print_freedom(mechanism, found);
  print_tangent(mechanism.structure());
  print_limits(mechanism.description());
  text::located(whole, [&] { print_start(mechanism, start); });
  check_run(document, overrides, builtins);
}

}  // namespace tandem::cli
