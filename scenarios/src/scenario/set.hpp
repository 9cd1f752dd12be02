// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <toml++/toml.h>

#include <string>

namespace tandem::scenario {

/// Puts "KEY=VALUE" into a scenario. KEY is a dotted path: `coordination.schedule`,
/// `subsystems.fast.parameters.k2`, `record.ports[0]`; a connection is named by its index or by its `to`,
/// `connections[0].gain`, `connections[fast.x2].gain`, and `connections.gain` means all of them. A key with a
/// dot in it stands in quotes: `run."data.load"`. VALUE is TOML, or else a text without quotes. A key that
/// the table has not is added (whether it may be there, the reader of the table says); subsystems and
/// connections are not. A subsystem's source takes the place of its command, and the other way round. Throws
/// Error that names what is there.
void set(toml::table& scenario, const std::string& override_text);

}  // namespace tandem::scenario
