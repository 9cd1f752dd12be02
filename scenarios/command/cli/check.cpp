// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/commands.hpp"
#include "cli/own_process.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/transports/open.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem::cli {
namespace {

struct CheckOptions {
  std::string source;
  double start = 0.0;
  std::vector<std::string> inputs;
};

/// "NAME=VALUE", or "NAME[2]=VALUE" of an array port, as its scalar's place and value.
void set_input(const SubsystemInfo& info, const std::string& text, std::vector<double>& inputs) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw Error(ErrorCode::invalid_argument, "--input " + text + ": allowed is NAME=VALUE");
  Parameters value;
  value.set(text.substr(0, equals), text.substr(equals + 1));
  std::vector<std::string> names;
  for (int k = 0; k < info.input_size(); ++k) {
    names.push_back(scalar_at(info.inputs, k).name());
    if (names.back() != text.substr(0, equals)) continue;
    inputs[static_cast<std::size_t>(k)] = value.number(names.back(), 0.0);
    return;
  }
  throw Error(ErrorCode::invalid_argument, "--input: " + unknown("input", text.substr(0, equals), names));
}

CheckSettings settings_of(const CheckOptions& options, const Subsystem& subsystem,
                          const std::vector<bool>& constant) {
  CheckSettings settings{options.start, {}, constant};
  settings.inputs.assign(static_cast<std::size_t>(subsystem.info().input_size()), std::nan(""));
  for (const std::string& text : options.inputs) set_input(subsystem.info(), text, settings.inputs);
  return settings;
}

/// Each in a process of its own where one process can't have several.
std::function<std::unique_ptr<Subsystem>()> opener(const std::string& source, const Builtins& builtins,
                                                   bool isolated) {
  return [&, isolated] {
    Opening opening;
    opening.isolated = isolated;
    return open(source, builtins, std::move(opening));
  };
}

std::vector<Finding> findings_of(const CheckOptions& options, const Context& context, const Tell& tell) {
  tell(options.source + ", opened");
  const bool is_code = source_of(options.source, context.builtins).code;
  const Look look = (is_code ? look_at(options.source, context.builtins, {}) : std::nullopt).value_or(Look{});
  const auto another = opener(options.source, context.builtins, look.once_per_process);
  const auto settings = settings_of(options, *another(), look.discrete);
  std::vector<Finding> findings;
  for (const std::string& name : check_names()) {
    tell(options.source + ", check '" + name + "'");
    const auto some = check(name, another, settings);
    findings.insert(findings.end(), some.begin(), some.end());
  }
  return findings;
}

void check_source(const CheckOptions& options, const Context& context, const Tell& tell) {
  const auto findings = findings_of(options, context, tell);
  std::size_t wrong = 0;
  for (const Finding& f : findings) {
    const bool is_wrong = f.kind == Finding::Kind::wrong;
    wrong += is_wrong ? 1 : 0;
    if (is_wrong || !context.quiet) say("{}: {}: {}\n", is_wrong ? "wrong" : "left out", f.check, f.sentence);
  }
  const std::size_t all = check_names().size();
  if (wrong > 0)
    throw RunFailed(fmt::format("{}: {} of {} checks found something wrong", options.source, wrong, all));
  if (!context.quiet) say("{}: {} checks, nothing wrong\n", options.source, all - findings.size());
}

}  // namespace

void add_check(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("check", "Try a subsystem as the contract says that it may be used");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("source", options->source, "The subsystem, as in a scenario: mechanism:FILE?step=1e-3")
      ->required()
      ->type_name("SOURCE");
  command->add_option("--start", options->start, "Time of the start [s]")
      ->check(finite)
      ->capture_default_str()
      ->type_name("T");
  command
      ->add_option("--input", options->inputs,
                   "Value of an input at the start, from which it moves by about 1 unless an FMU takes "
                   "constants alone "
                   "(repeatable; default: its own start value, or about 1)")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  command->footer(
      "Some 100 own steps: ports, start, steps, early returns, landing, saved states, several instances.\n"
      "Exit status: 0; 1 if something is wrong; 2 if the source can't be opened.");
  command->callback([options, &all = context] {
    Context looking = all;
    looking.builtins = without_matrices(all.builtins);
    in_own_process([&](const Tell& tell) { check_source(*options, looking, tell); });
  });
}

}  // namespace tandem::cli
