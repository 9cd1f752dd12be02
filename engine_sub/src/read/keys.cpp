// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/keys.hpp"

#include <fmt/format.h>

#include <cmath>

#include "blocks/kinds.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/text/file_parameters.hpp"
#include "tandem/text/limits.hpp"
#include "tandem/text/series.hpp"

namespace tandem::engine {
namespace {

using text::KeyList;

void keys_of_file(KeyList& to) {
  to.may("name", Type::text, "Its name; without it the file's.")
      .may("description", Type::text, "A sentence about it.");
  text::keys_of_parameters(to);
  to.named("inputs", "Signals from outside: ports.", "An input.")
      .need("unit", Type::text, "Its unit.", {.allowed = "like \"N\""})
      .named("outputs", "Signals for others: ports.", "An output.")
      .need("unit", Type::text, "Its unit.", {.allowed = "like \"rad/s\""})
      .may("from", Type::signal, "The signal; without it the one of that name.");
  text::keys_of_limits(to, "which is located as an event", Type::signal);
}

void keys_of_integrators(KeyList& to) {
  const IntegratorSettings s;
  const AdaptiveSettings& a = s.adaptive;
  const auto shown = [](double value) { return fmt::format("{}", value); };
  to.may("integrator", Type::word, "Of time: `rk4` takes the own step; the others are those of SUNDIALS.",
         {.otherwise = s.name,
          .words = {"arkstep", "cvode_adams", "cvode_bdf", "erkstep", "erkstep_fixed", "rk4"}})
      .may("locate_events", Type::flag, "`rk4` ends a part of a step at events; else at its end.",
           {.otherwise = s.locate_events ? "true" : "false"})
      .may("relative_tolerance", Type::positive, "Of each state, of an integrator that chooses its steps.",
           {.otherwise = shown(a.relative_tolerance)})
      .may("absolute_tolerance", Type::positive, "Likewise; `absolute_tolerance.STATE` of one alone.",
           {.otherwise = shown(a.absolute_tolerance)})
      .may("longest_step", Type::number, "Of its own; 0: no limit.",
           {.unit = "s", .otherwise = shown(a.longest_step)})
      .may("shortest_step", Type::number, "One that would be shorter ends the run.",
           {.unit = "s", .otherwise = shown(a.shortest_step)})
      .may("most_steps", Type::number, "Within one own step; more end the run.",
           {.otherwise = shown(static_cast<double>(a.most_steps))});
}

void keys_of_runs(KeyList& to) {
  to.table("loops", "What is done about algebraic loops; the table of the outermost diagram counts.")
      .may("solve", Type::flag, "They are solved; else they are refused.", {.otherwise = "false"})
      .may("tolerance", Type::positive, "Relative, or absolute for a signal below 1.", {.otherwise = "1e-12"})
      .may("most_iterations", Type::positive, "Of Newton's method.",
           {.otherwise = "50.0", .allowed = "1 to 1e6"})
      .table("loops.guess", "Where loops are cut, and where to begin.")
      .may("NAME", Type::number, "By the signal; without one somewhere, and at 0.")
      .table("run",
             "How it runs alone, and its settings where a scenario says nothing else: these are `parameters` "
             "there.")
      .may("start", Type::number, "The begin of the run.", {.unit = "s", .otherwise = "0.0"})
      .may("stop", Type::number, "Its end, which it has to have to be run alone.", {.unit = "s"})
      .may("step", Type::positive,
           "Its own step, which has to stand here or in the scenario, unless it is sampled.", {.unit = "s"});
  keys_of_integrators(to);
  to.may("NAME", Type::value, "A parameter of the file.")
      .table("run.inputs", "What its inputs are.")
      .table("run.inputs.NAME", "A number, or data over time.")
      .or_numbers();
  text::keys_of_series(to);
}

/// Of a parameter or a state of a compiled kind.
void keys_of_quantity(KeyList& to, const CompiledBlock::Quantity& quantity, Type type, const char* sentence) {
  if (std::isnan(quantity.otherwise))
    to.need(quantity.name, type, sentence);
  else
    to.may(quantity.name, type, sentence, {.otherwise = fmt::format("{}", quantity.otherwise)});
}

void keys_of_compiled(KeyList& to, const CompiledBlock& kind) {
  to.kind(kind.kind, "A kind that is written in C++.");
  for (const std::string& name : kind.inputs) to.need(name, Type::signal, "An input.");
  for (const auto& one : kind.parameters) keys_of_quantity(to, one, Type::number, "A parameter.");
  for (const auto& one : kind.states) keys_of_quantity(to, one, Type::signal, "A state at the start.");
}

void keys_of_blocks(KeyList& to, const std::vector<CompiledBlock>& kinds) {
  std::vector<std::string> words;
  for (const BlockKind& kind : kinds_of_blocks()) words.emplace_back(kind.name);
  for (const CompiledBlock& kind : kinds) words.push_back(kind.kind);
  to.named("blocks", "What signals are made of.", "A block; its name is that of its signal.", true)
      .need("kind", Type::word, "What it is.", {.words = words});
  for (const BlockKind& kind : kinds_of_blocks()) {
    to.kind(kind.name, kind.sentence);
    kind.keys(to);
  }
  for (const CompiledBlock& kind : kinds) keys_of_compiled(to, kind);
}

}  // namespace

text::Keys diagram_keys(const std::vector<CompiledBlock>& kinds) {
  KeyList list;
  keys_of_file(list);
  keys_of_blocks(list, kinds);
  keys_of_runs(list);
  return text::Keys(std::move(list).list(), text::Keys::Texts::refer);
}

}  // namespace tandem::engine
