// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/key_list.hpp"

namespace tandem::scenario {

/// The language of scenario files.
const text::Keys& keys();

/// Of these, the tables record, reference, judge and view; and ladder.
void keys_of_results(text::KeyList& to);
void keys_of_ladder(text::KeyList& to);

}  // namespace tandem::scenario
