// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/diagram.hpp"

#include "engine_models/compiled.hpp"

namespace tandem::diagrams {

void add_sources(Builtins& builtins, const TellOfDiagram& tell) {
  builtins.files["diagram"] = [tell](const std::filesystem::path& file, Parameters& p) {
    return make_diagram({file}, p, engine_models::compiled_kinds(), tell);
  };
}

}  // namespace tandem::diagrams
