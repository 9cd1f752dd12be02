// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/transports/open.hpp"

namespace tandem {

/// "functions:FILE": a multibody model whose terms are functions, in Octave (FILE.m) or in a shared library.
Source functions_source();

}  // namespace tandem
