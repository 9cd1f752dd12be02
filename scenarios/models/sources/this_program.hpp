// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem {

/// The file of the program that runs; empty where the system does not say.
std::string this_program();

/// That of another one in the same folder; empty if it is not there.
std::string program_beside(const std::string& name);

}  // namespace tandem
