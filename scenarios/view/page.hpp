// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace tandem::view {

/// The page of one file: the frame that was built into the program (page/ with the libraries and
/// their licences), and the data in it. Throws Error that names the packages if they were absent when tandem
/// was built.
std::string page(const nlohmann::ordered_json& data);

/// Throws the Error that page() would.
void check_page();

}  // namespace tandem::view
