// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "document.hpp"
#include "structure.hpp"

namespace tandem::ssp {

struct NamedValue {
  std::string name;
  Given given;
};

/// What a parameter binding gives, inline or in files, with the names that it, its prefix and its mapping make.
std::vector<NamedValue> values_of(const Document& document, xml_node binding);

/// The linear transformation of a connection or of an entry of a mapping. Throws Error for any other.
Transformation read_transformation(const Document& document, xml_node of);

}  // namespace tandem::ssp
