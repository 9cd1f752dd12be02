// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/sources/diagram.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::diagrams {

/// "diagram:FILE": make_diagram, with the compiled blocks of scenes.
void add_sources(Builtins& builtins, const TellOfDiagram& tell = {});

}  // namespace tandem::diagrams
