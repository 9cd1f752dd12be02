// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace tandem::engine_models {

// What the charts of scenarios/engine show, as the text of CSV files. folder: of the diagrams. Each throws
// Error for a diagram that is not there or not right.

/// Steady torque of engine.toml over its range: `rpm,throttle,torque` [deg], [N m], each plate angle in turn.
std::string torque_map(const std::filesystem::path& folder);

/// The governor's step from 2000 to 3000 rpm at 5 s, with 25 N m, from 2 to 8 s 20 N m:
/// `time,set,rpm,throttle, pressure,torque`, 10 s.
std::string step_response(const std::filesystem::path& folder);

/// The kart in its plane through its manoeuvre of 10 s: `time,throttle,gear,ratio,fill,rpm,torque,pitch`.
std::string manoeuvre(const std::filesystem::path& folder);

}  // namespace tandem::engine_models
