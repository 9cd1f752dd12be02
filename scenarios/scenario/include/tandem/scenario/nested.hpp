// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/text/file_parameters.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// "scenario:FILE": a whole scenario as one subsystem.
/// - Inputs: those of its members ("member.port") that neither a connection nor data give, from their start values.
/// - Outputs: what it records ([record] ports), or all.
/// - Own step: the parameter `step` [s]; else that of the slowest member, or its communication step. Its members
///   end a step where an own step ends; what goes on within one is told at its end.
/// - Parameters: see nested_parameters().
///
/// Its span's length says how far it may be run: a thousand times as far. The coordination is its own; what it
/// records besides is not looked at.
///
/// members: sources that its members may be of, all of which land and are made here. They may be scenarios too.
Source nested_source(Builtins members);

/// Puts that of mechanisms and diagrams, as `all` has them, into it.
void add_nested(Builtins& all);

/// What may be set of a source that is a file, with its values. Of "mechanism:FILE" and "diagram:FILE" these are the
/// parameters of the file. Of "scenario:FILE" they are its constants that are numbers, and parameters of the files
/// that its members are made of, as "member.NAME". Those that it makes of constants are not among them. Other sources
/// have none.
/// - folder: of a file that is not named from the root.
/// - given: values in place of the file's.
std::vector<text::FileParameter> parameters_of(const std::string& source, const std::filesystem::path& folder,
                                               const std::vector<std::string>& overrides, Parameters& given);

}  // namespace tandem::scenario
