// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>

#include "tandem/fmi/description.hpp"

namespace tandem::fmi {

// Words of descriptions.

/// Elements that are types: in 2.0 within a variable, in 3.0 the variable itself.
const std::map<std::string, Type>& types_of(Version version);
std::string listed_types(const std::map<std::string, Type>& types);
const std::map<std::string, Causality>& causalities();
const std::map<std::string, Variability>& variabilities();

/// The numbers of a type that a double holds exactly.
struct Range {
  double least, most;
};
Range range_of(Type type);

}  // namespace tandem::fmi
