// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <toml++/toml.h>

#include <string>
#include <string_view>

#include "tandem/text/set_value.hpp"

namespace tandem::text {

/// Where the bracket ends that is open at `at`: at its own ']', as names may have elements, "connections[c.u[1]]"; npos:
/// nowhere.
std::size_t end_of_bracket(std::string_view path, std::size_t at);

/// Puts "KEY=VALUE" into a file's table. KEY is a dotted path: `coordination.schedule`, `rods.crank.mass`,
/// `record.ports[0]`; one of several tables is named by its index or by its `to`, `connections[0].gain`,
/// `connections[fast.x2].gain`, and `connections.gain` means all of them. A name with a dot in it stands in
/// quotes: `run."absolute_tolerance.x"`. VALUE is TOML, or else a text without quotes. A key that the table
/// has not is added; whether it may be there, the reader of the table says. Where a table holds others by
/// name, as [rods] does, a new one is added as a whole only. A subsystem's source takes the place of its
/// command, and the other way round. Throws Error that names what is there.
void set(toml::table& file, const std::string& override_text);

/// What stands for a text as TOML: "2.5" and "[1, 2]" for themselves, "fast" in quotes.
std::string toml_value(const std::string& text);
/// A text in quotes, whatever it holds.
std::string toml_text(const std::string& text);

/// The same with a value of its own: a number as the double that it is, a text as a text.
void set(toml::table& file, const std::string& path, const SetValue& value);

}  // namespace tandem::text
