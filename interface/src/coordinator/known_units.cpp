// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "known_units.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace tandem {
namespace {

using Unit = KnownUnit;

// Factors: BIPM, The International System of Units, 9th ed. (2019), tables 2 to 8.
constexpr double pi = std::numbers::pi;
constexpr std::array units = {
    Unit{"1", "ratio", 1.0},
    Unit{"%", "ratio", 0.01},
    Unit{"s", "time", 1.0},
    Unit{"ms", "time", 1e-3},
    Unit{"us", "time", 1e-6},
    Unit{"min", "time", 60.0},
    Unit{"h", "time", 3600.0},
    Unit{"Hz", "frequency", 1.0},
    Unit{"1/s", "frequency", 1.0},
    Unit{"kHz", "frequency", 1e3},
    Unit{"m", "length", 1.0},
    Unit{"mm", "length", 1e-3},
    Unit{"cm", "length", 1e-2},
    Unit{"km", "length", 1e3},
    Unit{"m/s", "speed", 1.0},
    Unit{"mm/s", "speed", 1e-3},
    Unit{"km/h", "speed", 1.0 / 3.6},
    Unit{"m/s^2", "acceleration", 1.0},
    Unit{"rad", "angle", 1.0},
    Unit{"deg", "angle", pi / 180.0},
    Unit{"rev", "angle", 2.0 * pi},
    Unit{"rad/s", "angular speed", 1.0},
    Unit{"deg/s", "angular speed", pi / 180.0},
    Unit{"rpm", "angular speed", pi / 30.0},
    Unit{"rad/s^2", "angular acceleration", 1.0},
    Unit{"kg", "mass", 1.0},
    Unit{"g", "mass", 1e-3},
    Unit{"t", "mass", 1e3},
    Unit{"kg/s", "mass flow", 1.0},
    Unit{"g/s", "mass flow", 1e-3},
    Unit{"N", "force", 1.0},
    Unit{"mN", "force", 1e-3},
    Unit{"kN", "force", 1e3},
    Unit{"N m", "torque", 1.0},
    Unit{"kN m", "torque", 1e3},
    Unit{"Pa", "pressure", 1.0},
    Unit{"kPa", "pressure", 1e3},
    Unit{"MPa", "pressure", 1e6},
    Unit{"bar", "pressure", 1e5},
    Unit{"mbar", "pressure", 100.0},
    Unit{"W", "power", 1.0},
    Unit{"kW", "power", 1e3},
    Unit{"J", "energy", 1.0},
    Unit{"kJ", "energy", 1e3},
    Unit{"kWh", "energy", 3.6e6},
    Unit{"K", "temperature", 1.0},
    Unit{"degC", "temperature", 1.0, 273.15},
    Unit{"V", "voltage", 1.0},
    Unit{"mV", "voltage", 1e-3},
    Unit{"A", "current", 1.0},
    Unit{"mA", "current", 1e-3},
    Unit{"mol", "amount of substance", 1.0},
    Unit{"cd", "luminous intensity", 1.0},
};

}  // namespace

std::span<const KnownUnit> known_units() { return units; }

const KnownUnit* known_unit(std::string_view name) {
  const auto it = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
  return it == units.end() ? nullptr : &*it;
}

}  // namespace tandem
