// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::output {

// What results say of where they come from.

/// Of this build: tandem's version, the compiler with its version and the configuration, and the commit of
/// the source ("unknown" without git).
std::string version();
std::string compiler();
std::string source_commit();

/// The processor that this runs on; "unknown" where the system does not say.
std::string processor_model();

}  // namespace tandem::output
