// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "tandem/transports/open.hpp"

namespace tandem {

/// All that the scenes bring along: their models, and files of mechanisms, diagrams and functions. `tell`
/// takes what the limits of a model tell.
void add_sources(Builtins& builtins, const std::function<void(const std::string&)>& tell = {});

}  // namespace tandem
