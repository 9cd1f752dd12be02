// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/run_table.hpp"

#include "tandem/text/section.hpp"

namespace tandem {

void take_run_table(const text::Document& document, Parameters& to) {
  const toml::table* run = document.table()["run"].as_table();
  if (!run) return;
  for (const auto& [name, node] : text::in_file_order(*run)) {
    if (name == "start" || name == "stop" || node->is_table() || to.has(name)) continue;
    if (const auto* text = node->as_string())
      to.set(name, text->get());
    else if (const auto* flag = node->as_boolean())
      to.set(name, flag->get());
    else
      to.set(name, text::number_of(document, *node, "run." + name));
  }
}

}  // namespace tandem
