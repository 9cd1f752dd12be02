// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/diagram.hpp"

#include "engine_models/compiled.hpp"

namespace tandem::diagrams {

void add_sources(Builtins& builtins, const TellOfDiagram& tell) {
  const auto make = [tell](const Address& address, Parameters& p) {
    return make_diagram({address.file(), {}, address.overrides}, p, engine_models::compiled_kinds(), tell);
  };
  builtins.schemes["diagram"] = {diagram_words(), make};
}

}  // namespace tandem::diagrams
