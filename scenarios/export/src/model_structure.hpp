// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "tandem/exported/unit.hpp"

namespace tandem::exported {

/// The places of a unit's variables of these kinds.
std::vector<std::size_t> of_kinds(const Unit& unit, const std::vector<Variable::Kind>& kinds);

/// How a structure calls variable k: 2.0 counts variables from 1, 3.0 has value references.
inline std::string reference_of(std::size_t k, bool two) { return std::to_string(two ? k + 1 : k); }

/// The element ModelStructure: what depends on what (FMI 2.0, chapter 2.2.8; FMI 3.0, chapter 2.4.8).
/// - two: of FMI 2.0.
void write_structure(pugi::xml_node to, const Unit& unit, bool two);

}  // namespace tandem::exported
