// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/fmi/description.hpp"
#include "tandem/fmi/xml.hpp"

namespace tandem::fmi {

/// Outputs, derivatives of states and event indicators, and of which variables they follow at once. The
/// description's variables have been read.
void read_structure(const Xml& xml, pugi::xml_node structure, Description& d);

}  // namespace tandem::fmi
