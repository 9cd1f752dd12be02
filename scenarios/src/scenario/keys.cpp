// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/keys.hpp"

#include "tandem/coordinator/coordination.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/error.hpp"

namespace tandem::scenario {
namespace {

using text::Key;
using Type = Key::Type;

std::vector<std::string> schedules() {
  std::vector<std::string> words;
  for (const auto kind : {Schedule::Kind::slowest_first, Schedule::Kind::fastest_first,
                          Schedule::Kind::staggered, Schedule::Kind::parallel})
    words.emplace_back(Schedule::name(kind));
  return words;
}

std::vector<std::string> starts() {
  std::vector<std::string> words;
  for (const auto kind : {StartKind::automatic, StartKind::derivatives, StartKind::repeat, StartKind::cold})
    words.emplace_back(name(kind));
  return words;
}

bool is_reconstruction(const std::string& word) try {
  return Reconstruction::parse(word), true;
} catch (const Error&) {
  return false;
}

std::vector<Key> of_file() {
  return {
      {.path = "name", .type = Type::text, .sentence = "Its name; without it the file's."},
      {.path = "description", .type = Type::text, .sentence = "A sentence that `tandem list` prints."},
      {.path = "parameters",
       .type = Type::table,
       .sentence = "Parameters that every subsystem gets, before its own."},
      {.path = "parameters.NAME",
       .type = Type::value,
       .sentence = "As the source of each subsystem knows it."},
      {.path = "subsystems",
       .type = Type::table,
       .sentence = "The subsystems, a table for each.",
       .required = true},
  };
}

std::vector<Key> of_subsystems() {
  return {
      {.path = "subsystems.NAME",
       .type = Type::table,
       .sentence =
           "A subsystem, by the name that connections and results have. It has a `source` or a `command`."},
      {.path = "subsystems.NAME.source",
       .type = Type::text,
       .sentence =
           "Where it comes from, a URI: `mechanism:FILE`, `diagram:FILE`, `lib:FILE`, `spawn:PROGRAM`, "
           "`tcp://HOST:PORT`, ...; `tandem list` has all. Files stand relative to the scenario's folder."},
      {.path = "subsystems.NAME.command",
       .type = Type::texts,
       .sentence =
           "A program and its arguments, which is started and speaks the protocol on its standard input and "
           "output (in place of `source`).",
       .allowed = "at least one"},
      {.path = "subsystems.NAME.parameters",
       .type = Type::table,
       .sentence = "Its parameters: settings of its source and parameters of its model."},
      {.path = "subsystems.NAME.parameters.NAME",
       .type = Type::value,
       .sentence = "`tandem info SOURCE` tells which there are."},
      {.path = "subsystems.NAME.inputs",
       .type = Type::table,
       .sentence =
           "Values of its inputs, in the units of the ports: where an input is connected before the first "
           "exchange, else all the time."},
      {.path = "subsystems.NAME.inputs.NAME",
       .type = Type::numbers,
       .sentence = "The value, or one for each element of the port. Without it: that of the port."},
      {.path = "subsystems.NAME.land",
       .type = Type::word,
       .sentence =
           "Whether one that can cut a step ends one at each instant of a sampled subsystem that it reads or "
           "that reads it; `automatic`: if that one's period is at least its own step.",
       .otherwise = "automatic",
       .words = {"automatic", "always", "never"}},
  };
}

std::vector<Key> of_connections() {
  return {
      {.path = "connections[]",
       .type = Type::tables,
       .sentence = "From an output to an input of the same unit."},
      {.path = "connections[].from",
       .type = Type::text,
       .sentence = "The output.",
       .allowed = "\"instance.port\" or \"instance.port[i]\"",
       .required = true},
      {.path = "connections[].to",
       .type = Type::text,
       .sentence = "The input.",
       .allowed = "\"instance.port\" or \"instance.port[i]\"",
       .required = true},
      {.path = "connections[].reconstruction",
       .type = Type::word,
       .sentence = "How the input is made a function of time from samples of the output. A held output needs "
                   "none; any other has to have one.",
       .allowed = "`least_squaresD_EXTRA`: degree D 0 to 4 through 1 to 16 EXTRA samples",
       .words = {"lagrange0", "lagrange1", "lagrange2", "lagrange3", "lagrange4", "hermite", "mean",
                 "matched_hold"},
       .pattern = "least_squares[0-4]_([1-9]|1[0-6])",
       .also = is_reconstruction},
      {.path = "connections[].gain",
       .type = Type::number,
       .sentence = "The input is gain times output plus offset.",
       .otherwise = "1.0"},
      {.path = "connections[].offset",
       .type = Type::number,
       .sentence = "See gain; in the unit of the input.",
       .otherwise = "0.0"},
      {.path = "connections[].add",
       .type = Type::flag,
       .sentence = "The input is the sum of this and other connections, which all say so.",
       .otherwise = "false"},
      {.path = "connections[].convert",
       .type = Type::flag,
       .sentence =
           "Where the units differ and are of one kind, the number is converted from the output's to the "
           "input's.",
       .otherwise = "false"},
      {.path = "connections[].memory",
       .type = Type::flag,
       .sentence =
           "The reader gets at t what the output was one own step of the reader before; between sampled "
           "subsystems the value just before the instant.",
       .otherwise = "false"},
      {.path = "connections[].delay",
       .type = Type::flag,
       .sentence = "The reader gets at t what the output was one `coordination.communication_step` before.",
       .otherwise = "false"},
  };
}

std::vector<Key> of_coordination() {
  return {
      {.path = "coordination", .type = Type::table, .sentence = "Who goes first, and how the run starts."},
      {.path = "coordination.schedule",
       .type = Type::word,
       .sentence =
           "Whose turn it is: with `slowest-first` the slow one goes ahead on extrapolated inputs and the "
           "fast ones follow, with `fastest-first` the other way round; `staggered`: the slow one steps in "
           "the "
           "middle of its step, of two with matched hold; `parallel`: all go to the next communication "
           "point.",
       .otherwise = "slowest-first",
       .words = schedules()},
      {.path = "coordination.order",
       .type = Type::texts,
       .sentence =
           "The subsystems that integrate themselves, the slowest first: with `slowest-first` the first one "
           "leads, with `fastest-first` the last one. Without it: by the length of their own steps.",
       .allowed = "each once"},
      {.path = "coordination.communication_step",
       .type = Type::positive,
       .sentence =
           "Time between the communication points of `parallel`, and the time of a `delay`. Without it: the "
           "own step of the slowest.",
       .unit = "s"},
      {.path = "coordination.start",
       .type = Type::word,
       .sentence =
           "How histories are filled before the first step: from `derivatives` of the outputs, by a "
           "`repeat` of the first steps, or not (`cold`, of low order at first); `automatic`: the first of "
           "these that can be.",
       .otherwise = "automatic",
       .words = starts()},
      {.path = "coordination.coupling",
       .type = Type::word,
       .sentence = "What the subsystems exchange.",
       .otherwise = "signals",
       .words = {"signals"}},
  };
}

std::vector<Key> of_span() {
  return {
      {.path = "span", .type = Type::table, .sentence = "The time of the run.", .required = true},
      {.path = "span.start", .type = Type::number, .sentence = "Its begin.", .unit = "s", .otherwise = "0.0"},
      {.path = "span.stop",
       .type = Type::number,
       .sentence = "Its end.",
       .unit = "s",
       .allowed = "after `start`",
       .required = true},
      {.path = "span.diverged_beyond",
       .type = Type::number,
       .sentence =
           "The run ends as diverged where an output exceeds so many times the largest of its magnitude in "
           "the first hundredth of the span, its port's nominal value and 1; `inf`: never.",
       .otherwise = "1e8",
       .allowed = "above 1, or `inf`"},
  };
}

}  // namespace

const text::Keys& keys() {
  static const text::Keys all = [] {
    std::vector<Key> list;
    for (auto part : {of_file(), of_subsystems(), of_connections(), of_coordination(), of_span(),
                      keys_of_results(), keys_of_ladder()})
      list.insert(list.end(), part.begin(), part.end());
    return text::Keys(std::move(list));
  }();
  return all;
}

}  // namespace tandem::scenario
