// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace tandem {

/// The one of `candidates` nearest to `text` by edit distance, for "did you mean"; empty if none is near.
std::string nearest(std::string_view text, const std::vector<std::string>& candidates);

/// "a, b, c", or "none".
std::string listed(const std::vector<std::string>& names);

/// "subsystem 'fsat' is not there; did you mean 'fast'? There are: fast, slow"
std::string unknown(const std::string& kind, const std::string& found, const std::vector<std::string>& known);

}  // namespace tandem
