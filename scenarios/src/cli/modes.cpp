// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.hpp"
#include "cli/mechanism_info.hpp"
#include "scenario/scenario.hpp"
#include "sources/elements.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/text/document.hpp"

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
    fmt::print("{:>9} Hz {:>8.4f}  {:<16} {}\n", frequency(mode), damping(mode), name_of(mechanism, mode),
               most);
  else
    fmt::print("{:>9.3g} 1/s          {:<16} {}\n", mode.p.real(), name_of(mechanism, mode), most);
}

/// Motions that nothing pulls back have p = 0 but for rounding, which is that of a mechanism of its size:
/// those of a thousand times the length are slower by the root of it.
void print_modes(const std::filesystem::path& file) {
  mbs::Mechanism mechanism(mbs::read_mechanism(file, element_kinds()));
  const mbs::State s = mbs::initial_state(mechanism, start_of(file));
  const auto all = mbs::modes(mechanism, s);
  const double still = 1e-2 / std::sqrt(mechanism.structure().unit());  // [1/s]
  const auto free =
      std::count_if(all.begin(), all.end(), [still](const auto& m) { return std::abs(m.p) < still; });
  fmt::print("{}: modes about its start\n  frequency  damping  name             kinetic energy\n",
             mechanism.description().name);
  for (const mbs::Mode& mode : all)
    if (std::abs(mode.p) >= still) print_mode(mechanism, mode);
  fmt::print("  {} solutions with |p| < {:.3g} 1/s: nothing pulls back\n", free, still);
}

void print_modes_of_scenario(const std::string& file) {
  const auto scenario = scenario::read(file);
  const std::string scheme = "mechanism:";
  bool any = false;
  for (const auto& s : scenario.subsystems) {
    if (!s.source.starts_with(scheme)) continue;
    print_modes(scenario.file.parent_path() / s.source.substr(scheme.size()));
    any = true;
  }
  if (!any)
    throw Error(ErrorCode::invalid_argument,
                file + " has no mechanism; allowed is a scenario with a source mechanism:FILE");
}

}  // namespace

void add_modes(CLI::App& app, Context&) {
  auto* command = app.add_subcommand(
      "modes", "Linearize a mechanism about its start: frequency, damping and shape of its modes");
  auto file = std::make_shared<std::string>();
  command->add_option("what", *file, "A mechanism, or a scenario with mechanisms")
      ->required()
      ->type_name("FILE");
  command->footer("Exit status: 0, or 2 for what is not right.");
  command->callback([file] { is_mechanism(*file) ? print_modes(*file) : print_modes_of_scenario(*file); });
}

}  // namespace tandem::cli
