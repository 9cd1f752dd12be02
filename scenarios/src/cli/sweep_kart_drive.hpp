// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "cli/commands.hpp"

namespace tandem::cli {

/// Writes drive.csv: torque on the driven shaft, speed and pitch of the kart's level ii over its manoeuvre,
/// kart and power train as one system by the classical Runge-Kutta method at 0.1 ms.
void sweep_kart_drive(const std::filesystem::path& output, const Context& context);

}  // namespace tandem::cli
