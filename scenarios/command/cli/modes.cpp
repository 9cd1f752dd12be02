// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/check_run.hpp"
#include "cli/commands.hpp"
#include "cli/mechanism_info.hpp"
#include "cli/say.hpp"
#include "sources/elements.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/parts.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::cli {
namespace {

std::string frequency(const mbs::Mode& mode) {
  const double hertz = mode.frequency();
  return hertz < 0.01 ? fmt::format("{:.3g}", hertz) : fmt::format("{:.3f}", hertz);
}

/// Without a sign where it is zero as printed.
double damping(const mbs::Mode& mode) { return std::round(1e4 * mode.damping()) / 1e4 + 0.0; }

void print_mode(const mbs::Mechanism& mechanism, const mbs::Mode& mode) {
  std::string most;
  const auto shares = mbs::shares(mechanism, mode);
  for (std::size_t k = 0; k < std::min<std::size_t>(3, shares.size()) && shares[k].part >= 0.005; ++k)
    most += fmt::format("{}{} {:.0f} %", k > 0 ? ", " : "", shares[k].name, 100.0 * shares[k].part);
  if (mode.oscillates())
    say("{:>9} Hz {:>8.4f}  {:<16} {}\n", frequency(mode), damping(mode), name_of(mechanism, mode), most);
  else
    say("{:>9.3g} 1/s          {:<16} {}\n", mode.p.real(), name_of(mechanism, mode), most);
}

/// Motions that nothing pulls back have p = 0 but for rounding, which is that of a mechanism of its size:
/// those of a thousand times the length are slower by the root of it.
void print_modes(mbs::Description description, double start) {
  const std::string told = take_unknown_inputs_as_zero(description);
  mbs::Mechanism mechanism(std::move(description));
  const mbs::State s = mbs::initial_state(mechanism, start);
  const auto all = mbs::modes(mechanism, s);
  const std::string& name = mechanism.description().name;
  if (all.empty()) return say("{}: no modes, for its constraints leave no motion\n", name);
  const double still = 1e-2 / std::sqrt(mechanism.structure().unit());  // [1/s]
  const auto free =
      std::count_if(all.begin(), all.end(), [still](const auto& m) { return std::abs(m.p) < still; });
  say("{}: modes about its start\n{}  frequency  damping  name             kinetic energy\n", name, told);
  for (const mbs::Mode& mode : all)
    if (std::abs(mode.p) >= still) print_mode(mechanism, mode);
  say("  {} solutions with |p| < {:.3g} 1/s: nothing pulls back\n", free, still);
}

/// Of a mechanism alone, with any values of its file set.
void print_modes_of_file(const std::string& file, const std::vector<std::string>& overrides,
                         const Builtins& builtins) {
  text::Document document{std::filesystem::path(file)};
  document.set(overrides);
  check_run(document, overrides, builtins);
  Parameters none;
  print_modes(describe_mechanism({file, {}, overrides}, none, element_kinds()), start_of(document));
}

/// What the scenario says of the mechanism: parameters, and inputs at the start.
mbs::Description described(const scenario::SubsystemEntry& entry, double start, const Builtins& builtins) {
  scenario::Parts::opened(entry, builtins);  // all that it is given is right
  Parameters given = query_of(entry.source);
  for (const scenario::Parameter& p : entry.parameters) given.set(p.name, p.value);
  auto d = describe_mechanism({entry.file(), {}, entry.overrides}, given, element_kinds());
  std::vector<std::string> names;
  for (const mbs::Input& input : d.inputs) names.push_back(input.name);
  for (const scenario::InputEntry& input : entry.inputs) {
    const auto at = std::find(names.begin(), names.end(), input.port);
    if (at == names.end()) text::refuse(input.place, unknown("input", input.port, names));
    d.inputs[static_cast<std::size_t>(at - names.begin())].value = input.at(start);
  }
  return d;
}

void print_modes_of_scenario(const std::string& file, const std::vector<std::string>& overrides,
                             const Builtins& builtins) {
  const auto scenario = scenario::read(file, overrides);
  bool any = false;
  for (const auto& s : scenario.subsystems) {
    if (s.scheme() != "mechanism") continue;
    print_modes(described(s, scenario.start, builtins), scenario.start);
    any = true;
  }
  if (!any)
    throw Error(ErrorCode::invalid_argument,
                file + " has no mechanism; allowed is a scenario with a source mechanism:FILE");
}

struct ModesOptions {
  std::string what;
  std::vector<std::string> overrides;
};

}  // namespace

void add_modes(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "modes", "Linearize a mechanism about its start: frequency, damping and shape of its modes");
  auto options = std::make_shared<ModesOptions>();
  command->add_option("what", options->what, "A mechanism, or a scenario with mechanisms")
      ->required()
      ->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->footer("Exit status: 0, or 2 for what is not right.");
  command->callback([options, &context] {
    const auto& [what, overrides] = *options;
    is_mechanism(what) ? print_modes_of_file(what, overrides, context.builtins)
                       : print_modes_of_scenario(what, overrides, context.builtins);
  });
}

}  // namespace tandem::cli
