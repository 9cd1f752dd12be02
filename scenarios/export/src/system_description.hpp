// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "member.hpp"

namespace tandem::exported {

/// The file of a component below resources/: a name that needs no code in a URI, one for each component.
std::string file_of(const std::string& component);

/// SystemStructure.ssd of a scenario: its components, one for each subsystem, and its connections. tool: who
/// writes it. Throws Error for what a system has no words for.
std::string system_description(const scenario::Scenario& scenario, const std::vector<SystemMember>& members,
                               const std::string& tool);

}  // namespace tandem::exported
