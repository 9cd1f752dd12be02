// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/bytes.hpp"
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// A state that leaves the process.
void write(const State& state, ByteWriter& to);
/// Into a state of the same model, whose vectors have their sizes. Refuses other sizes.
void read(State& state, ByteReader& from);

}  // namespace tandem::mbs
