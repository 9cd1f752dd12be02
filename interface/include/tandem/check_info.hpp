// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/subsystem.hpp"

namespace tandem {

/// The most scalars that the inputs, or the outputs, of a subsystem may have.
constexpr int most_scalars = 1 << 24;

/// What every subsystem has to say of itself, wherever it lives. `name`: what errors call it. Throws
/// Error(invalid_argument) for port names, sizes, derivatives or feedthrough that make no sense.
void check_info(const std::string& name, const SubsystemInfo& info);

}  // namespace tandem
