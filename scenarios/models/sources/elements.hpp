// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem {

/// The elements of scenes that mechanisms' files may name.
mbs::ElementKinds element_kinds();

}  // namespace tandem
