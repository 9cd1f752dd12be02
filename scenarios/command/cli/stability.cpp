// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <thread>

#include "cli/say.hpp"
#include "cli/study_file.hpp"
#include "cli/sweep_study.hpp"
#include "cli/validators.hpp"
#include "tandem/charts/draw.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/stability/fast_period.hpp"
#include "tandem/stability/largest_step.hpp"
#include "tandem/stability/modes.hpp"
#include "tandem/study/stability_map.hpp"

namespace tandem::cli {
namespace {

struct StabilityOptions {
  std::string file;
  std::vector<std::string> overrides, map;
  std::filesystem::path output;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

std::string verdict(const stability::Stability& all) {
  const double rounding = all.step.rounding();
  if (all.is_unstable())
    return fmt::format("unstable: it grows by {:.3g} of itself each super-step", all.radius - 1.0);
  if (all.radius > 1.0 + rounding) return "what grows grows in the system undivided too";
  return all.radius < 1.0 - rounding ? "stable, and all motion dies out" : "stable";
}

void tell(const scenario::Scenario& scenario, const stability::Stability& all) {
  std::string steps;
  for (std::size_t i = 0; i < all.step.steps.size(); ++i)
    steps += fmt::format("{}{} {}", i ? ", " : "", scenario.subsystems[i].name, all.step.steps[i]);
  say("{}: {}\n", scenario.file.string(), verdict(all));
  say("super-step: {:.6g} s, own steps: {}\n", all.step.period, steps);
  if (all.step.apart > 0.0)
    say("their ends meet but for {:.2g} of a step, which is taken for meeting\n", all.step.apart);
  for (const stability::Identified& one : all.step.identified)
    say("{} {}: a linear model of order {} stands for it, which leaves {:.2g} of its responses\n", one.name,
        one.sampled ? "is sampled" : "keeps its states to itself", one.order, one.residual);
  for (const std::string& remark : scenario.remarks) say("note: {}\n", remark);
  if (!all.step.linear) say("note: subsystems are not linear; this is about the state at the start\n");
  say("spectral radius: {:.10g}\n\n", all.radius);
  if (!all.unknown.empty()) return say("modes: not known; {}\n", all.unknown);
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
      say("\nlargest stable step: none, down to {} of the scenario's steps\n", largest.smallest);
    else if (std::isinf(largest.factor))
      say("\nlargest stable step: any, up to {} times the scenario's steps\n", largest_factor);
    else
      say("\nlargest stable step: {}{:.6g} s, {} ({:.6g} s here), the others in proportion\n",
          largest.beyond.empty() ? "" : "at least ", largest.factor * largest.step, whose, largest.step);
    if (!largest.beyond.empty()) say("longer steps could not be looked at: {}\n", largest.beyond);
  } catch (const Error& error) {
    say("\nlargest stable step: not known; {}\n", error.what());
  }
}

/// "x=..." or "y=...".
study::MapAxis axis(const std::vector<std::string>& map, const std::string& name) {
  for (const std::string& text : map)
    if (text.starts_with(name + "=")) return study::MapAxis::from_text(text.substr(2));
  throw Error(ErrorCode::invalid_argument,
              fmt::format("--map {}: {} is missing; allowed is x=KEY:FROM:TO:COUNT y=KEY:FROM:TO:COUNT",
                          fmt::join(map, " "), name));
}

void draw_map(const StabilityOptions& options, const Context& context) {
  const std::string study =
      study::stability_map(options.file, options.overrides, axis(options.map, "x"), axis(options.map, "y"));
  const auto folder = options.output.empty() ? results_of(options.file) : options.output;
  sweep_study({options.file, folder, options.overrides, {}, "", options.threads, false, false, study},
              context);
  const auto drawing = charts::draw(study::read(options.file, study).charts, folder, "");
  for (const charts::Picture& picture : drawing.pictures)
    say("wrote {}\n", picture.draw(folder, charts::Format::svg).string());
}

}  // namespace

void add_stability(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "stability", "Tell whether a scenario's scheme is stable, and what it does to each mode");
  auto options = std::make_shared<StabilityOptions>();
  command->add_option("scenario", options->file, "The scenario, a TOML file or a system of SSP")
      ->required()
      ->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--map", options->map,
                   "Sweep two keys of the file, and draw where it is stable; with :log behind it an axis "
                   "goes by equal "
                   "ratios")
      ->type_name("x=KEY:FROM:TO:COUNT y=KEY:FROM:TO:COUNT")
      ->expected(2);
  command
      ->add_option("--output", options->output,
                   "Of --map: folder for the table and the chart (default: results/FOLDER, that of the file)")
      ->type_name("DIR");
  command->add_option("--threads", options->threads, "Of --map: rows that are made at a time")
      ->check(threads);
  command->footer("Exit status: 0, also of an unstable one; 2 for what is wrong before.");
  command->callback([options, &context] {
    if (!options->map.empty()) return draw_map(*options, context);
    const Builtins builtins = without_matrices(context.builtins);
    const auto scenario =
        stability::with_fast_period(scenario::read(options->file, options->overrides), builtins);
    tell(scenario, stability::stability(scenario, builtins));
    tell_largest(scenario, builtins);
  });
}

}  // namespace tandem::cli
