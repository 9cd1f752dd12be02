// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/transports/open.hpp"

namespace tandem::functions {

/// The scheme "functions": a model in Octave (FILE.m) or in a shared library.
void add_sources(Builtins& builtins);

}  // namespace tandem::functions
