// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/fmi/description.hpp"
#include "tandem/fmi/xml.hpp"

namespace tandem::fmi {

/// The variables below the root of a description, in their order.
std::vector<Variable> read_variables(const Xml& xml, pugi::xml_node root, Version version);

}  // namespace tandem::fmi
