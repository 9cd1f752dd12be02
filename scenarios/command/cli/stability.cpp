// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "cli/say.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::cli {
namespace {

struct StabilityOptions {
  std::string file;
  std::vector<std::string> overrides;
};

std::string verdict(double radius) {
  constexpr double rounding = 1e-9;  // of eigenvalues that meet at 1
  if (radius > 1.0 + rounding)
    return fmt::format("unstable: it grows by {:.3g} of itself each super-step", radius - 1.0);
  return radius < 1.0 - rounding ? "stable, and all motion dies out" : "stable";
}

void tell(const scenario::Scenario& scenario, const stability::Stability& all) {
  std::string steps;
  for (std::size_t i = 0; i < all.step.steps.size(); ++i)
    steps += fmt::format("{}{} {}", i ? ", " : "", scenario.subsystems[i].name, all.step.steps[i]);
  say("{}: {}\n", scenario.file.string(), verdict(all.radius));
  say("super-step: {:.6g} s, own steps: {}\n", all.step.period, steps);
  if (!all.step.linear) say("note: subsystems are not linear; this is about the state at the start\n");
  say("spectral radius: {:.10g}\n\n", all.radius);
  say("{:>14} {:>14} {:>12} {:>12} {:>10}  {}\n", "frequency [Hz]", "of the scheme", "damping",
      "of the scheme", "growth", "states");
  for (const stability::Mode& mode : all.modes)
    say("{:14.6g} {:14.6g} {:12.3g} {:12.3g} {:10.6g}  {}{}\n", mode.frequency, mode.scheme_frequency,
        mode.damping, mode.scheme_damping, mode.growth, all.mostly(mode),
        !mode.is_kept() ? "  (the scheme has no mode like it)" : "");
}

void tell_largest(const scenario::Scenario& scenario, const Builtins& builtins) {
  using namespace stability;
  try {
    const LargestStep largest = largest_step(scenario, builtins);
    const std::string whose =
        largest.whose == "communication step" ? largest.whose : "own step of " + largest.whose;
    if (largest.factor == 0.0)
      say("\nlargest stable step: none, down to {} of the scenario's steps\n", smallest_factor);
    else if (std::isinf(largest.factor))
      say("\nlargest stable step: any, up to {} times the scenario's steps\n", largest_factor);
    else
      say("\nlargest stable step: {:.6g} s, {} ({:.6g} s here), the others in proportion\n",
          largest.factor * largest.step, whose, largest.step);
  } catch (const Error& error) {
    say("\nlargest stable step: not known; {}\n", error.what());
  }
}

}  // namespace

void add_stability(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "stability", "Tell whether a scenario's scheme is stable, and what it does to each mode");
  auto options = std::make_shared<StabilityOptions>();
  command->add_option("scenario", options->file, "The scenario, a TOML file")->required()->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->footer("Exit status: 0, also of an unstable one; 2 for what is wrong before.");
  command->callback([options, &context] {
    const auto scenario = scenario::read(options->file, options->overrides);
    const Builtins builtins = without_matrices(context.builtins);
    tell(scenario, stability::stability(scenario, builtins));
    tell_largest(scenario, builtins);
  });
}

}  // namespace tandem::cli
