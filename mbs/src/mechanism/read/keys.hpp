// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/key_list.hpp"

namespace tandem::mbs {

// The tables of a mechanism's file, part by part.
void keys_of_constraints(text::KeyList& to);
void keys_of_forces(text::KeyList& to);
void keys_of_outputs(text::KeyList& to);
void keys_of_runs(text::KeyList& to);

}  // namespace tandem::mbs
