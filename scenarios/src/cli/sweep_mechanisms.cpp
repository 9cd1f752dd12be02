// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_mechanisms.hpp"

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "mechanisms/formulations.hpp"
#include "output/conditions.hpp"
#include "tandem/error.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/parallel.hpp"

namespace tandem::cli {
namespace {

void stop_if_interrupted() {
  if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing more is written");
}

void write_table(const std::filesystem::path& file, const char* header,
                 const std::vector<std::string>& rows) {
  std::string text = std::string(header) + "\n";
  for (const std::string& row : rows) text += row + "\n";
  output::write_text(file, text);
}

void write_figures(const MechanismSweep& sweep, bool shown) {
  const auto cases = mechanisms::formulation_cases();
  std::vector<std::string> figures(cases.size()), errors(cases.size());
  Progress progress("sweep", cases.size(), shown);
  output::for_each_in_parallel(
      cases.size(), sweep.threads,
      [&](std::size_t i) {
        const auto row = mechanisms::formulation_row(cases[i], sweep.mechanisms);
        figures[i] = row.figures;
        errors[i] = row.error;
      },
      [&](std::size_t done) {
        progress.update(done);
        return !InterruptGuard::interrupted();
      });
  stop_if_interrupted();
  write_table(sweep.output / "formulations.csv", mechanisms::formulations_header, figures);
  write_table(sweep.output / "errors.csv", mechanisms::errors_header, errors);
}

/// One at a time, for the times.
void write_work(const MechanismSweep& sweep, bool shown) {
  const auto cases = mechanisms::work_cases();
  std::vector<std::string> rows;
  Progress progress("work ", cases.size(), shown);
  for (const auto& c : cases) {
    stop_if_interrupted();
    rows.push_back(mechanisms::work_row(c, sweep.mechanisms));
    progress.update(rows.size());
  }
  write_table(sweep.output / "work.csv", mechanisms::work_header, rows);
  const output::Measured measured{"see each card", "distance from the truth at the end [m or rad]",
                                  "the least of up to 5"};
  output::write_text(sweep.output / "work_conditions.json", output::conditions(measured).dump(2) + "\n");
}

}  // namespace

void sweep_mechanisms(const MechanismSweep& sweep, const Context& context) {
  const InterruptGuard guard;
  if (!std::filesystem::is_directory(sweep.mechanisms))
    throw Error(ErrorCode::input_output, "folder '" + sweep.mechanisms.string() + "' is not there");
  const KeptFolder folder(sweep.output);
  write_figures(sweep, !context.quiet);
  if (!sweep.only_table) write_work(sweep, !context.quiet);
  if (!context.quiet) say("wrote {}\n", (sweep.output / "formulations.csv").string());
}

}  // namespace tandem::cli
