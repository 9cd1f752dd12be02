// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/text/keys.hpp"

namespace tandem::scenario {

/// The language of scenario files.
const text::Keys& keys();

/// Of these, the tables record, reference, judge and view; and ladder.
std::vector<text::Key> keys_of_results();
std::vector<text::Key> keys_of_ladder();

}  // namespace tandem::scenario
