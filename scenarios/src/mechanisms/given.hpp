// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "tandem/text/file_parameters.hpp"

namespace tandem::mechanisms {

/// Of the parameters that a mechanism's file declares, those that somebody else gives: find(NAME) tells.
text::GivenValues given_values(const text::Document& document,
                               const std::function<std::optional<text::FileValue>(const std::string&)>& find);

}  // namespace tandem::mechanisms
