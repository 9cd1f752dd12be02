// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "kart/tyres.hpp"
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem {

/// The elements of scenes that mechanisms' files may name; `words` as in kart::element_kinds().
mbs::ElementKinds element_kinds(const kart::TyreWords& words = {});

}  // namespace tandem
