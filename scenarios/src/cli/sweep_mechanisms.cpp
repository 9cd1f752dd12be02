// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_mechanisms.hpp"

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "mechanisms/formulations.hpp"
#include "output/files.hpp"
#include "output/parallel.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {

void sweep_mechanisms(const MechanismSweep& sweep, const Context& context) {
  const InterruptGuard guard;
  if (!std::filesystem::is_directory(sweep.mechanisms))
    throw Error(ErrorCode::input_output, "folder '" + sweep.mechanisms.string() + "' is not there");
  output::make_folder(sweep.output);
  const auto cases = mechanisms::formulation_cases();
  std::vector<mechanisms::FormulationRow> rows(cases.size());
  Progress progress("sweep", cases.size(), !context.quiet);
  output::for_each_in_parallel(
      cases.size(), sweep.threads,
      [&](std::size_t i) { rows[i] = mechanisms::formulation_row(cases[i], sweep.mechanisms); },
      [&](std::size_t done) {
        progress.update(done);
        return !InterruptGuard::interrupted();
      });
  if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing is written");
  std::string figures = std::string(mechanisms::formulations_header) + "\n",
              errors = std::string(mechanisms::errors_header) + "\n";
  for (const auto& row : rows) figures += row.figures + "\n", errors += row.error + "\n";
  output::write_text(sweep.output / "formulations.csv", figures);
  output::write_text(sweep.output / "errors.csv", errors);
  if (!context.quiet) fmt::print("wrote {}\n", (sweep.output / "formulations.csv").string());
}

}  // namespace tandem::cli
