// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string_view>

namespace tandem {

/// A unit that has a name here: in SI units scale * value + zero.
struct KnownUnit {
  std::string_view name, quantity;
  double scale, zero = 0.0;
};

std::span<const KnownUnit> known_units();
/// Null: there is none of that name.
const KnownUnit* known_unit(std::string_view name);

}  // namespace tandem
