// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/section.hpp"

namespace tandem::scenario {

/// Puts the table [constants] of a scenario into `to`, which is what stands behind `root`. Each may be of the
/// others, in any order. Throws Error with file and line for a name that is not there, and for a ring of them.
void read_constants(text::Section& root, text::Values& to);

/// Refuses a constant that the command line or a study has set and that no text of the file names: it would be without
/// effect.
void refuse_unnamed_constants(const text::Document& document);

}  // namespace tandem::scenario
