// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include "tandem/text/keys.hpp"

namespace tandem::scenario {

/// A JSON schema (draft 2020-12) of the files of a language, for editors: an unknown key, a wrong type and a
/// word that is not allowed are wrong by it, and a required key that is missing.
nlohmann::ordered_json schema(const text::Keys& language, const std::string& title);

}  // namespace tandem::scenario
