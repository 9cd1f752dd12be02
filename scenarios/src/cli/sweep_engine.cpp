// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_engine.hpp"

#include <fmt/format.h>

#include "cli/kept_folder.hpp"
#include "cli/say.hpp"
#include "engine_models/sweep.hpp"
#include "output/conditions.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/files.hpp"

namespace tandem::cli {

void sweep_engine(const std::filesystem::path& diagrams, const std::filesystem::path& output,
                  const Context& context) {
  const KeptFolder folder(output);
  const auto write = [&](const char* name, const std::string& text) {
    output::write_text(output / name, text);
    if (!context.quiet) say("wrote {}\n", (output / name).string());
  };
  write("torque_map.csv", engine_models::torque_map(diagrams));
  const char* const printed = "printed_torque_map.csv";
  output::write_text(output / printed, read_file(diagrams / printed, std::uint64_t{1} << 20));
  write("step_response.csv", engine_models::step_response(diagrams));
  write("manoeuvre.csv", engine_models::manoeuvre(diagrams));
  const auto conditions = output::conditions(
      {"the specification's figures (points)", "none: the curves are the models' own", "1"});
  write("conditions.json", conditions.dump(2) + "\n");
}

}  // namespace tandem::cli
