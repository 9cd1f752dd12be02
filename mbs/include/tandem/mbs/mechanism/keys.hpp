// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/force_element.hpp"
#include "tandem/text/keys.hpp"

namespace tandem::mbs {

/// The language of mechanism files: what they are read by. kinds: of elements, besides the own ones.
text::Keys mechanism_keys(const ElementKinds& kinds = {});

}  // namespace tandem::mbs
