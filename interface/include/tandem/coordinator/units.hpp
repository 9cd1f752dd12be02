// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace tandem {

/// value in the second unit = factor * value in the first + shift.
struct UnitConversion {
  double factor, shift;
};

/// What a unit is in SI base units: value in these = factor * value + offset. As the element BaseUnit of FMI 2.0
/// (section 2.2.2) and SSP 1.0.
struct BaseUnit {
  std::array<int, 8> exponents = {};  ///< of kg, m, s, A, K, mol, cd, rad
  double factor = 1.0, offset = 0.0;
  static constexpr std::array<const char*, 8> names = {"kg", "m", "s", "A", "K", "mol", "cd", "rad"};
};

/// Of a unit that tandem knows (rpm, N m, degC, ...) or that is a product, a quotient or a power of such ones:
/// "N m/rad", "kg m^2", "1/(s K)", also as FMI writes it, "kg.m2"; with an offset in base units, "0.5 K + 255".
/// Nothing for any other text.
std::optional<BaseUnit> base_unit(std::string_view text);

/// The text of a unit that tandem knows, if those that are the same are of one quantity (a torque and an energy
/// are of two); else of a product: "0.001 kg m^2 s^-2", "0.5 K + 255".
std::string unit_text(const BaseUnit& unit);

/// How tandem writes a unit that a file calls `name` and defines by base units: as it is called if that text
/// means the same here, angles left aside, else by the base units.
std::string unit_text(std::string_view name, const BaseUnit& means);

/// The conversion between two units of one quantity that tandem knows (rpm and rad/s, bar and Pa, ...), or of
/// equal base units. Nothing if one is unknown, or they measure different quantities. Equal texts always
/// convert, with factor 1.
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
