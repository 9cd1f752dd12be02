// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/units.hpp"

#include <array>

#include "known_units.hpp"

namespace tandem {

/// Those that have names here are of a quantity (a torque is no energy, a speed no frequency); of others the
/// base units tell.
std::optional<UnitConversion> convert_unit(std::string_view from, std::string_view to) {
  if (from == to) return UnitConversion{1.0, 0.0};
  const KnownUnit *known_from = known_unit(from), *known_to = known_unit(to);
  if (known_from && known_to && known_from->quantity != known_to->quantity) return std::nullopt;
  const auto a = base_unit(from), b = base_unit(to);
  if (!a || !b || a->exponents != b->exponents) return std::nullopt;
  return UnitConversion{a->factor / b->factor, (a->offset - b->offset) / b->factor};
}

std::optional<EnergyProduct> energy_product(std::string_view effort, std::string_view along) {
  struct Pair {
    std::string_view effort, along;
    bool is_power;
  };
  constexpr std::array pairs = {Pair{"force", "speed", true}, Pair{"torque", "angular speed", true},
                                Pair{"voltage", "current", true}, Pair{"force", "length", false},
                                Pair{"torque", "angle", false}};
  const KnownUnit *a = known_unit(effort), *b = known_unit(along);
  if (!a || !b) return std::nullopt;
  for (const Pair& pair : pairs)
    if (pair.effort == a->quantity && pair.along == b->quantity)
      return EnergyProduct{pair.is_power, a->scale * b->scale};
  return std::nullopt;
}

double displacement_scale(std::string_view unit) {
  const KnownUnit* u = known_unit(unit);
  return u && (u->quantity == "length" || u->quantity == "angle") ? u->scale : 1.0;
}

}  // namespace tandem
