// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string_view>

namespace tandem {

/// value in the second unit = factor * value in the first + shift.
struct UnitConversion {
  double factor, shift;
};

/// The conversion between two units of the same quantity that tandem knows (rpm and rad/s, deg and rad, bar
/// and Pa, ...); nothing if one is unknown or they measure different quantities. Equal texts always convert,
/// with factor 1.
std::optional<UnitConversion> convert_unit(std::string_view from, std::string_view to);

}  // namespace tandem
