// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "cli/commands.hpp"
#include "cli/diagram_info.hpp"
#include "cli/looking.hpp"
#include "cli/mechanism_info.hpp"
#include "cli/print_parameter.hpp"
#include "cli/say.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::cli {
namespace {

std::string unit(const Port& port) { return port.unit.empty() ? "not said" : port.unit; }

std::string shape(const Port& port) { return port.size > 1 ? fmt::format("[{}]", port.size) : ""; }

void print_inputs(const SubsystemInfo& info, const std::vector<double>& start) {
  say("  inputs:{}\n", info.inputs.empty() ? " none" : "");
  std::size_t k = 0;
  for (const Port& port : info.inputs) {
    std::string values;
    for (int e = 0; e < port.size; ++e, ++k)
      values +=
          (e > 0 ? ", " : "") + (std::isnan(start[k]) ? std::string("none") : fmt::format("{}", start[k]));
    say("    {}{}  unit {}, start value {}\n", port.name, shape(port), unit(port), values);
  }
}

std::vector<std::string> scalar_names(const std::vector<Port>& ports) {
  std::vector<std::string> names;
  for (const Port& port : ports)
    for (int e = 0; e < port.size; ++e) names.push_back(Scalar{&port, e}.name());
  return names;
}

void print_outputs(const SubsystemInfo& info) {
  say("  outputs:{}\n", info.outputs.empty() ? " none" : "");
  for (const Port& port : info.outputs)
    say("    {}{}  unit {}, {}{}\n", port.name, shape(port), unit(port),
        port.held ? "held" : fmt::format("{} time derivatives", port.derivatives),
        port.nominal == 1.0 ? "" : fmt::format(", usual magnitude {}", port.nominal));
  say("  feedthrough:{}\n", info.feedthrough.empty() ? " none" : "");
  const auto outputs = scalar_names(info.outputs), inputs = scalar_names(info.inputs);
  for (const Feedthrough& f : info.feedthrough)
    say("    {} at once from {}\n", outputs[static_cast<std::size_t>(f.output)],
        inputs[static_cast<std::size_t>(f.input)]);
}

void print_abilities(const Abilities& a) {
  std::string text;
  const auto add = [&](bool has, const char* what) {
    text += has ? (text.empty() ? "" : ", ") + std::string(what) : "";
  };
  add(a.chooses_step, "chooses its step");
  add(a.lands, "lands (can cut a step)");
  add(a.saves_state, "saves its state");
  add(a.serializes_state, "gives its state as bytes (for checkpoints)");
  add(a.restarts, "restarts");
  add(a.reactive_inputs, "reactive inputs");
  add(a.sampled, "sampled (acts at instants of its own)");
  add(a.events, "stops where its outputs jump");
  say("  abilities: {}\n", text.empty() ? "none" : text);
}

struct Span {
  double start = 0.0, stop = 1.0;
};

/// The first own step, as the subsystem gives it when nothing is known of its inputs but their start values.
double own_step(Subsystem& subsystem, const Span& span, const std::vector<double>& start) {
  std::vector<double> row(static_cast<std::size_t>(subsystem.info().row_size()));
  Samples y(row.data(), subsystem.info().row_size(), 1);
  const Clock clock = subsystem.initialize(span.start, span.stop, start, y);
  return clock.next_time - clock.time;
}

void print(const std::string& name, Subsystem& subsystem, const Span& span,
           const std::vector<double>& start) {
  const SubsystemInfo& info = subsystem.info();
  say("{}: {}\n", name, info.name);
  for (const DeclaredParameter& p : info.parameters) print_parameter(p);
  print_inputs(info, start);
  print_outputs(info);
  print_abilities(info.abilities);
  const double step = own_step(subsystem, span, start);
  if (info.abilities.sampled)
    say("  period: {:.6g} s, first instant after {:.6g} s, outputs change {:.6g} s after an instant\n",
        info.sampling.period, step, info.sampling.latency);
  else
    say("  first own step: {:.6g} s\n", step);
}

/// One that is code, as far as it was looked at.
void print_not_opened(const std::string& name, const Look* look, const std::vector<double>& start) {
  if (!look) return say("{}: not opened\n", name);
  say("{}: {}\n", name, look->info.name);
  for (const std::string& sentence : look->sentences) say("  {}\n", sentence);
  if (!look->obstacle.empty()) say("  it can't be run here: {}\n", look->obstacle);
  for (const DeclaredParameter& p : look->parameters) print_parameter(p);
  print_inputs(look->info, start);
  print_outputs(look->info);
  print_abilities(look->info.abilities);
  look->own_step > 0.0 ? say("  own step: {:.6g} s\n", look->own_step)
                       : say("  own step: none; the parameter step has to be given\n");
}

void print_words(const Source& source) {
  const auto of = [&](Setter setter) {
    std::vector<std::string> names;
    for (const Word& word : source.words)
      if (word.setter == setter) names.push_back(word.name);
    return listed(names);
  };
  say("  parameters that a client of a server may set: {}; and those of the model itself\n",
      of(Setter::client));
  say("  parameters that only who serves it may set: {}\n", of(Setter::operator_only));
}

/// One that can't be made for want of a parameter tells all the same what it takes.
std::unique_ptr<Subsystem> open_or_tell(const std::string& uri, const Builtins& builtins) {
  try {
    return open(uri, builtins);
  } catch (const NotMade& error) {
    say("{}\n", uri);
    for (const DeclaredParameter& p : error.parameters()) print_parameter(p);
    throw;
  }
}

/// Those of the files that it is made of, with the values of the URI.
void print_parameters_of_files(const std::string& uri) {
  Parameters given = query_of(uri);
  for (const text::FileParameter& p : scenario::parameters_of(uri, {}, {}, given)) print_parameter(p);
}

void print_source(const std::string& uri, const Context& context) {
  Topology topology;
  if (const auto look = look_at(uri, context.builtins, {})) {
    topology.add("source", look->info);
    print_not_opened(uri, &*look, topology.start(0));
  } else {
    const auto subsystem = open_or_tell(uri, context.builtins);
    topology.add("source", subsystem->info());
    print(uri, *subsystem, {}, topology.start(0));
    print_parameters_of_files(uri);
  }
  print_words(source_of(uri, context.builtins));
}

std::string extras(const Connection& c) {
  std::string text;
  if (c.gain != 1.0) text += fmt::format(", gain {}", c.gain);
  if (c.offset != 0.0) text += fmt::format(", offset {}", c.offset);
  if (c.add) text += ", add";
  if (c.convert) text += ", convert";
  return text + (c.lag == Lag::memory ? ", memory" : c.lag == Lag::delay ? ", delay" : "");
}

struct InfoOptions {
  std::string what;
  std::vector<std::string> overrides;
  bool dot = false, run_programs = false;
};

void print_scenario(const InfoOptions& options, const Context& context) {
  const auto scenario = as_it_is_stated(scenario::read(options.what, options.overrides), context.builtins,
                                        options.run_programs);
  const scenario::Parts parts(scenario, context.builtins,
                              options.run_programs ? scenario::Code::run : scenario::Code::leave_out);
  const Topology& topology = parts.topology();
  say("{}{}{}\n", scenario.name, scenario.description.empty() ? "" : ": ", scenario.description);
  say("from {} to {} s, schedule {}\n", scenario.start, scenario.stop,
      Schedule::name(scenario.coordination.schedule));
  for (int i = 0; i < topology.size(); ++i)
    if (Subsystem* subsystem = parts.subsystem(i))
      print(topology.name(i), *subsystem, {scenario.start, scenario.stop}, topology.start(i));
    else
      print_not_opened(topology.name(i), parts.look(i), topology.start(i));
  say("connections:{}\n", scenario.connections.empty() ? " none" : "");
  for (const scenario::ConnectionEntry& entry : scenario.connections) {
    const Connection& c = entry.connection;
    say("  {} -> {}  {}{}\n", c.from, c.to, c.how ? c.how->name() : "held", extras(c));
  }
  say("{}", in_part(scenario, parts));
  for (const std::string& remark : scenario.remarks) say("note: {}\n", remark);
}

/// "builtin:NAME", "three_functions:FILE" and the like: letters, then a colon. "C:\..." is no source, nor is
/// a file that is there.
bool is_source(const std::string& text) {
  std::size_t letters = 0;
  while (letters < text.size() &&
         (std::isalpha(static_cast<unsigned char>(text[letters])) || text[letters] == '_'))
    ++letters;
  return letters > 1 && letters < text.size() && text[letters] == ':';
}

}  // namespace

void add_info(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("info",
                                     "Show parameters, ports, units, abilities and start values of a source "
                                     "or a scenario, or what a mechanism or a diagram has");
  auto options = std::make_shared<InfoOptions>();
  command
      ->add_option("what", options->what,
                   "A source such as builtin:NAME or builtin:NAME?KEY=VALUE&KEY=VALUE, a scenario, a "
                   "mechanism or a diagram")
      ->required()
      ->type_name("SOURCE|FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->add_flag("--dot", options->dot, "Print the graph of a diagram in the language of Graphviz");
  add_run_programs(*command, options->run_programs);
  command->footer(
      "A source is opened, code or not, but an FMU, of which the description is read and nothing is run. Of "
      "a scenario those that are code are opened with --run-programs "
      "only.\n"
      "Exit status: 0, or 2 for what is not right.");
  command->callback([options, &all = context] {
    Context looking = all;
    looking.builtins = without_matrices(all.builtins);
    const bool source = is_source(options->what);
    if (source && options->run_programs)
      throw Error(ErrorCode::invalid_argument, "--run-programs belongs to a scenario; a source is opened");
    if (source && !options->overrides.empty())
      throw Error(ErrorCode::invalid_argument,
                  "--set belongs to a file; a source takes its values as " + options->what + "?KEY=VALUE");
    if (source) return print_source(options->what, looking);
    const bool mechanism = is_mechanism(options->what), diagram = !mechanism && is_diagram(options->what);
    if (options->dot && !diagram)
      throw Error(ErrorCode::invalid_argument, "--dot belongs to a diagram; " + options->what + " is none");
    if (!mechanism && !diagram) return print_scenario(*options, looking);
    if (mechanism) return print_mechanism(options->what, options->overrides, looking.builtins);
    if (!options->dot) return print_diagram(options->what, options->overrides, looking.builtins);
    text::Document file{std::filesystem::path(options->what)};
    file.set(options->overrides);
    print_dot(file);
  });
}

}  // namespace tandem::cli
