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

/// An effort times what it acts along.
struct EnergyProduct {
  bool is_power;  ///< along a flow: force with speed, torque with angular speed, voltage with current; else a
                  ///< displacement: force with length, torque with angle
  double scale;   ///< [W] or [J] that the product of the two units is
};
/// Nothing for other quantities and for units that are unknown.
std::optional<EnergyProduct> energy_product(std::string_view effort, std::string_view along);
/// [m] or [rad] that a unit of length or angle is; 1 for any other.
double displacement_scale(std::string_view unit);

}  // namespace tandem
