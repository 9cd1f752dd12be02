// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/elements.hpp"

#include "kart/tyre_element.hpp"

namespace tandem {

mbs::ElementKinds element_kinds() { return kart::element_kinds(); }

}  // namespace tandem
