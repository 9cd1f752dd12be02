// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_split_pendulum.hpp"

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "output/conditions.hpp"
#include "split_pendulum/sweep.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/parallel.hpp"

namespace tandem::cli {

void sweep_split_pendulum(const std::filesystem::path& output, unsigned threads, const Context& context) {
  const InterruptGuard guard;
  const KeptFolder folder(output);
  const auto cases = split_pendulum::sweep_cases();
  const auto schemes = split_pendulum::limit_schemes();
  std::vector<std::string> rows(cases.size() + schemes.size());
  Progress progress("sweep", rows.size(), !context.quiet);
  output::for_each_in_parallel(
      rows.size(), threads,
      [&](std::size_t i) {
        rows[i] = i < cases.size() ? split_pendulum::scheme_row(cases[i])
                                   : split_pendulum::limit_row(schemes[i - cases.size()]);
      },
      [&](std::size_t done) {
        progress.update(done);
        return !InterruptGuard::interrupted();
      });
  if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing is written");
  const auto write = [&](const char* name, const char* header, std::size_t first, std::size_t last) {
    std::string text = std::string(header) + "\n";
    for (std::size_t i = first; i < last; ++i) text += rows[i] + "\n";
    output::write_text(output / name, text);
    if (!context.quiet) say("wrote {}\n", (output / name).string());
  };
  write("schemes.csv", split_pendulum::schemes_header, 0, cases.size());
  write("limits.csv", split_pendulum::limits_header, cases.size(), rows.size());
  output::write_text(
      output / "conditions.json",
      output::conditions({"Lagrange's equations to 1e-9 m", "largest distance of the elbow from it", "1"})
              .dump(2) +
          "\n");
}

}  // namespace tandem::cli
