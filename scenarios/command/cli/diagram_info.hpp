// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/text/document.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::cli {

/// True for a TOML file that has a table of blocks, as only diagrams do.
bool is_diagram(const std::filesystem::path& file);

/// Prints parameters, ports with units, states, feedthrough, events and what is left out, then checks its run.
/// overrides: "KEY=VALUE".
void print_diagram(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                   const Builtins& builtins);

/// The graph of blocks and signals in the language of Graphviz; blocks that are left out are dashed. A
/// diagram that is refused, for an algebraic loop say, is drawn before.
void print_dot(const text::Document& diagram);

}  // namespace tandem::cli
