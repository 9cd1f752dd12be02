// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "cli/looking.hpp"
#include "cli/run_to_results.hpp"
#include "cli/validators.hpp"

namespace tandem::cli {
namespace {

constexpr const char* footer = R"(
A scenario is code: the programs and libraries that it names are run with your rights. Of a stranger's scenario,
tandem validate SCENARIO names them and runs none.

Any value of the scenario can be set by its path:
  --set coordination.schedule=fastest-first         --set parameters.frequency_ratio=25
  --set connections[0].reconstruction=lagrange1     --set connections[fast.x2].gain=2 (by `to`)
  --set connections.reconstruction=hermite (all that have one)    --set span.stop=5

Results: results.csv (or results.INSTANCE.csv with record.clock = "own"), results.json (status, units, how cells were
interpolated, the scenario with what was set, versions), machine.json (steps, exchanges, seconds, real-time factor:
simulated seconds in a second; with --profile the seconds of each subsystem, and of the coordinator with the recording),
indicators.csv (how far the coupling is off, docs/indicators.md).
One run at a time writes to a folder: another is refused before it changes anything there.

Checkpoints (docs/checkpoints.md): a run that is resumed gives the same results to the last bit; every subsystem has to
have the ability to give its state as bytes. Rows are in results.csv at least once a second.

Exit status: 0; 1 for a run that failed, was interrupted (Ctrl-C) or is not within its reference's tolerance, with the
results until then kept; 2 for an error before the run.)";

}  // namespace

void add_run(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("run", "Run a scenario and write its results");
  auto options = std::make_shared<RunOptions>();
  command->add_option("scenario", options->file, "The scenario, a TOML file or a system of SSP")
      ->required()
      ->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--output", options->output, "Folder of the results (default: results/NAME of the file)")
      ->check(named)
      ->type_name("DIR");
  auto* dry = command->add_flag("--dry-run", options->dry,
                                "Check everything up to the first step, and write nothing");
  add_run_programs(*command, options->run_programs)->needs(dry);
  command->add_flag("--profile", options->profile,
                    "Take the seconds of each subsystem too (two clock readings a call)");
  command->add_flag(
      "--estimate", options->estimate,
      "Also say how far the output of [judge] is off, by linear models that are found before the run: "
      "record.indicators = \"estimate\"");
  command
      ->add_option(
          "--threads", options->threads,
          "Threads that make calls of a round at the same time, where these last above some 2 us; the "
          "results are the same")
      ->type_name("N")
      ->check(threads)
      ->capture_default_str();
  command->add_flag("--no-reference", options->no_reference,
                    "Don't compare with the reference that the scenario names");
  auto* dump = command
                   ->add_option("--dump-matrices", options->matrices.folder,
                                "Write M, Phi_q, K, C and the tangent of each mechanism to DIR/NAME")
                   ->type_name("DIR");
  command->add_option("--dump-at", options->matrices.times, "When, in s (default: at the start)")
      ->type_name("T,T...")
      ->needs(dump);
  command
      ->add_option("--dump-format", options->matrices.format,
                   "mtx: Matrix Market; ccs: compressed columns as text")
      ->check(one_of({"mtx", "ccs"}))
      ->capture_default_str()
      ->needs(dump);
  command
      ->add_option(
          "--checkpoint-every", options->checkpoint_every,
          "Write the whole run to DIR/checkpoint each time that it has come so many simulated seconds "
          "further, and when it is interrupted")
      ->check(number)
      ->type_name("SECONDS");
  command
      ->add_option("--resume", options->resume,
                   "Go on from a checkpoint, with the results in the same folder")
      ->type_name("FILE")
      ->excludes(dump);
  command->footer(footer);
  command->callback(
      [options, &context] { options->dry ? run_dry(*options, context) : run_to_results(*options, context); });
}

}  // namespace tandem::cli
