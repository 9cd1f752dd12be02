// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <variant>

#include "cli/say.hpp"

namespace tandem::cli {

/// Of a diagram or a mechanism.
template <class Parameter>
void print_parameter(const Parameter& p) {
  if (const auto* number = std::get_if<double>(&p.value))
    say("  parameter {} = {} {}\n", p.name, *number, p.unit);
  else
    say("  parameter {} = '{}'\n", p.name, std::get<std::string>(p.value));
}

}  // namespace tandem::cli
