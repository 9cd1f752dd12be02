// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/bytes.hpp"

namespace tandem::wire {

using Reader = ByteReader;
using Writer = ByteWriter;

}  // namespace tandem::wire
