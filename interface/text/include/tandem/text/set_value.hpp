// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <variant>

namespace tandem::text {

/// What a key of a file is set to.
using SetValue = std::variant<double, bool, std::string>;

/// "KEY=VALUE", as the command line would say it.
std::string override_of(const std::string& path, const SetValue& value);

}  // namespace tandem::text
