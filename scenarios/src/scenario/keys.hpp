// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/keys.hpp"

namespace tandem::scenario {

/// The language of scenario files.
const text::Keys& keys();

}  // namespace tandem::scenario
