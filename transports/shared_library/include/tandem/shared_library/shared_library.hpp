// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "tandem/transports/open.hpp"

namespace tandem {

/// The symbol that a library exports if no other is named.
inline constexpr const char* default_entry = "tandem_subsystem";

/// A new instance of the subsystem in a shared library that exports `entry` (tandem_subsystem_entry of
/// subsystem.h). The library stays loaded as long as the instance lives; one library may have any number of
/// instances. Throws Error that names the file for one that is not there or can't be loaded, a symbol that is
/// missing, and all that CSubsystem refuses.
std::unique_ptr<Subsystem> load_subsystem(const std::filesystem::path& file, const std::string& entry,
                                          const std::string& parameters);

/// Adds "lib:FILE?entry=NAME&key=value": every parameter but `entry` goes to the library; and
/// "three_functions:FILE" with the parameters step, inputs, outputs, initiate, advance, clean_up
/// (docs/shared_libraries.md).
void add_shared_library(Builtins& builtins);

}  // namespace tandem
