// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/keys.hpp"

#include "tandem/coordinator/coordination.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/error.hpp"
#include "tandem/text/series.hpp"

namespace tandem::scenario {
namespace {

using text::KeyList;

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

void of_file(KeyList& to) {
  using enum text::Key::Type;
  to.may("name", text, "Its name; without it the file's.")
      .may("description", text, "A sentence that `tandem list` prints.")
      .may("study", any, "A study of this scenario, for `tandem sweep` (docs/studies.md).",
           {.allowed = "a table"})
      .table(
          "constants",
          "Numbers by name, which may be of each other. Where a number may stand in this file, `\"$NAME\"` "
          "stands for "
          "one and `\"$(EXPRESSION)\"` for an expression of them.")
      .may("NAME", number, "The number.")
      .table("parameters", "Parameters that every subsystem gets, before its own.")
      .may("NAME", values, "As the source of each subsystem knows it.")
      .table("subsystems", "The subsystems, a table for each.", true);
}

void of_subsystems(KeyList& to) {
  using enum text::Key::Type;
  to.table("subsystems.NAME",
           "A subsystem, by the name that connections and results have. It has a `source` or a "
           "`command`.")
      .may("source", text,
           "Where it comes from, a URI: `mechanism:FILE`, `diagram:FILE`, `scenario:FILE`, `lib:FILE`, "
           "`fmu:FILE`, "
           "`spawn:PROGRAM`, `tcp://HOST:PORT`, ...; `tandem list` has all. Files stand relative "
           "to the scenario's folder.")
      .may("command", texts,
           "A program and its arguments, in place of `source`. It is started, and speaks the protocol on the "
           "socket whose number is in the environment as TANDEM_FD.",
           {.allowed = "at least one"})
      .may("isolate", flag,
           "Native code, `lib:`, `three_functions:`, `functions:` or `fmu:`, runs in a process of its own. "
           "It may have the "
           "parameters of `spawn:` too. A crash, or a call that does not end within its `deadline`, ends the "
           "run with a sentence.",
           {.otherwise = "false"})
      .may("land", word,
           "Whether one that can cut a step ends one at each instant of a sampled subsystem that "
           "it reads or that reads it; `automatic`: if that one's period is at least its own step.",
           {.otherwise = "automatic", .words = {"automatic", "always", "never"}})
      .table("subsystems.NAME.parameters",
             "Its parameters: settings of its source and parameters of its model.")
      .may(
          "NAME", values,
          "`tandem info SOURCE` tells which there are. A table `set = { k = 3 }` stands for `\"set.k\" = 3`, "
          "a list of names `outputs = [\"x\"]` for `\"outputs.x\" = true`, a list of numbers for the text of "
          "them with blanks between.")
      .table("subsystems.NAME.inputs",
             "What its inputs are, by port, or by element of one, `\"u[0]\"`, in the units of the ports. "
             "Without "
             "it: what the port says.")
      .table(
          "subsystems.NAME.inputs.NAME",
          "A number, or one for each element of the port: where the input is connected before the first "
          "exchange, else all the time. Or data over time, over the whole span, of one that is not "
          "connected. "
          "A subsystem that can shorten a step ends one where these jump, and where they bend unless that is "
          "more often than its own steps (see `land`).")
      .or_numbers();
  text::keys_of_series(to);
}

void of_connections(KeyList& to) {
  using enum text::Key::Type;
  to.table("connections[]", "From an output to an input of the same unit.")
      .need("from", text, "The output.", {.allowed = "\"instance.port\" or \"instance.port[i]\""})
      .need("to", text, "The input.", {.allowed = "\"instance.port\" or \"instance.port[i]\""})
      .may("reconstruction", word,
           "How the input is made a function of time from samples of the output. A held output "
           "needs none; any other has to have one.",
           {.allowed = "`least_squaresD_EXTRA`: degree D 0 to 4 through 1 to 16 EXTRA samples",
            .words = Reconstruction::words(),
            .pattern = Reconstruction::least_squares_words,
            .also = is_reconstruction})
      .may("gain", number, "The input is gain times output plus offset.", {.otherwise = "1.0"})
      .may("offset", number, "See gain; in the unit of the input.", {.otherwise = "0.0"})
      .may("add", flag, "The input is the sum of this and other connections, which all say so.",
           {.otherwise = "false"})
      .may("convert", flag,
           "Where the units differ and are of one kind, the number is converted from the output's "
           "to the input's.",
           {.otherwise = "false"})
      .may("memory", flag,
           "The reader gets at t what the output was one own step of the reader before; between "
           "sampled subsystems the value just before the instant.",
           {.otherwise = "false"})
      .may("delay", flag,
           "The reader gets at t what the output was one `coordination.communication_step` before.",
           {.otherwise = "false"});
}

void of_links(KeyList& to) {
  using enum text::Key::Type;
  to.table("links[]",
           "Two connections that carry a power, one each way, whose energy the indicators follow "
           "(docs/indicators.md). "
           "Those whose units say so are found without it.")
      .may("effort", text, "The output that is a force, torque or voltage.", {.allowed = "\"instance.port\""})
      .may("flow", text, "The output that comes back, a speed or a current.",
           {.allowed = "\"instance.port\""})
      .may(
          "displacement", edge,
          "In place of `flow`, a length or an angle. With `stiffness` both outputs, of the ends of a spring.",
          {.allowed = "\"instance.port\", or two of them"})
      .may("stiffness", positive, "That of the spring between two displacements.", {.unit = "N/m or N m/rad"})
      .may("velocity", text,
           "With `coordination.coupling`: the slow side's output that is the rate of `displacement`. Who "
           "reads it "
           "beside the displacement on the fast side gets that of the surrogate, as a damper needs.",
           {.allowed = "\"instance.port\""})
      .may("effective_mass", positive,
           "With `coordination.coupling`: the mass that the effort finds at the slow side. Without it: found "
           "at the "
           "start.",
           {.unit = "kg or kg m^2"})
      .may("accelerance", edge,
           "In place of `effective_mass`, where it varies: the output of the slow side that is the "
           "acceleration of the "
           "displacement by an effort of 1, with a derivative. Of several links on that side an output for "
           "each of "
           "their efforts, in the order of the file.",
           {.allowed = "\"instance.port\""})
      .may("effective_stiffness", positive,
           "Likewise its own springs, and with them `impulse` is `impulse_stiffness`: for fast sides that "
           "are not light beside it. `impulse_stiffness` finds them at the start without it.",
           {.unit = "N/m or N m/rad"})
      .may("effective_damping", positive, "Likewise its own dampers, beside `effective_stiffness`.",
           {.unit = "N s/m or N m s/rad"});
}

void of_coordination(KeyList& to) {
  using enum text::Key::Type;
  to.table("coordination", "Who goes first, and how the run starts.")
      .may("scheme", word,
           "`auto`: what the scenario leaves out of schedule, order, reconstructions and steps is taken "
           "before the "
           "run, by predicted error (docs/advice.md).",
           {.otherwise = "stated", .words = {"stated", "auto"}})
      .may("schedule", word,
           "Whose turn it is. `slowest-first`: the slow one goes ahead on extrapolated inputs and the fast "
           "ones follow. `fastest-first`: the other way round. `staggered`: of two with matched hold, the "
           "slow one steps in the middle of its step. `parallel`: all go to the next communication point.",
           {.otherwise = "slowest-first", .words = schedules()})
      .may("order", texts,
           "The subsystems that integrate themselves, the slowest first: with "
           "`slowest-first` the first one leads, with `fastest-first` the last one. Without "
           "it: by the length of their own steps.",
           {.allowed = "each once"})
      .may("communication_step", positive,
           "Time between the communication points of `parallel`, and the time of a `delay`. "
           "Without it: the own step of the slowest.",
           {.unit = "s"})
      .may("start", word,
           "How histories are filled before the first step. `derivatives`: from those of the outputs. "
           "`repeat`: by a repetition of the first steps. `cold`: not at all, so that the order is low at "
           "first. `automatic`: the first of these that can be.",
           {.otherwise = "automatic", .words = starts()})
      .may(
          "coupling", word,
          "What the subsystems exchange. `impulse`: over each of [[links]] the fast side gets a surrogate of "
          "the slow one, and the slow side a mean force (docs/impulse_coupling.md). `impulse_plain`: the "
          "surrogate is "
          "a mass. `impulse_stiffness`: it has springs and dampers, too. `impulse_taylor`: it has the slow "
          "side's "
          "own equations. `impulse`: the better of the first two that is known.",
          {.otherwise = "signals",
           .words = {"signals", "impulse", "impulse_plain", "impulse_stiffness", "impulse_taylor"}})
      .may("carrier", word,
           "Of `impulse`: how the slow side's reaction reaches the fast one. `reactive`: the fast side "
           "integrates "
           "the surrogate along with its own states, for which it has reactive inputs. `surrogate`: a "
           "subsystem "
           "beside it, which exchanges with it at each of its steps. `automatic`: the first where it can be.",
           {.otherwise = "automatic", .words = {"automatic", "reactive", "surrogate"}})
      .may("fast_period", positive,
           "Of `impulse`: the shortest period of the coupled system. Without it: that of the system "
           "undivided, "
           "about the start, in which a fast side takes part (docs/impulse_coupling.md).",
           {.unit = "s"});
}

void of_span(KeyList& to) {
  using enum text::Key::Type;
  to.table("span", "The time of the run.", true)
      .may("start", number, "Its begin.", {.unit = "s", .otherwise = "0.0"})
      .need("stop", number, "Its end.", {.unit = "s", .allowed = "after `start`"})
      .may("diverged_beyond", number,
           "The run ends as diverged where an output exceeds so many times the largest of "
           "its magnitude in the first hundredth of the span, its port's nominal value and "
           "1; `inf`: never.",
           {.otherwise = "1e8", .allowed = "above 1, or `inf`"});
}

}  // namespace

const text::Keys& keys() {
  static const text::Keys all = [] {
    KeyList list;
    for (const auto part : {of_file, of_subsystems, of_connections, of_links, of_coordination, of_span,
                            keys_of_results, keys_of_ladder})
      part(list);
    return text::Keys(std::move(list).list(), text::Keys::Texts::refer);
  }();
  return all;
}

}  // namespace tandem::scenario
