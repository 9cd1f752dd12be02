// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/check_run.hpp"

#include "tandem/scenario/parts.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::cli {

/// Without a stop the file is a part of a scenario, which may give the step.
void check_run(const text::Document& document, const std::vector<std::string>& overrides,
               const Builtins& builtins) {
  const std::filesystem::path file = document.file();
  const toml::table* run = document.table()["run"].as_table();
  if (!run) return;
  if (run->contains("stop")) {
    const scenario::Scenario alone = scenario::read(file, overrides);
    const scenario::Parts checked(alone, builtins, scenario::Code::run);
    return;
  }
  Opening opening{{}, file.parent_path(), {}, overrides};
  if (!run->contains("step")) opening.parameters.set("step", 1.0);
  text::located(document.place(*run), [&] {
    open(scenario::kind_alone(file) + ":" + file.filename().string(), builtins, std::move(opening));
  });
}

}  // namespace tandem::cli
