// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <pugixml.hpp>
#include <string>

#include "tandem/coordinator/units.hpp"
#include "tandem/exported/unit.hpp"
#include "tandem/fmi/description.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::exported {

/// What a description says besides the variables.
struct Facts {
  std::string identifier;  ///< of the library
  std::string name, description, tool;
  std::optional<TimeSpan> span;
  double step;  ///< own step, or period [s]
};

/// The text of modelDescription.xml, by the schemas of the standard (FMI 2.0, chapters 2.2 and 4.3; FMI 3.0,
/// chapters 2.4 and 4.4).
std::string model_description(const Unit& unit, const Facts& facts, fmi::Version version);

/// A unit of tandem as FMI tools write it: "kg.m2" of "kg m^2".
std::string fmi_unit(const std::string& unit);
/// The attributes of the element BaseUnit of FMI and SSP.
void write_base(pugi::xml_node to, const BaseUnit& base);

/// A page that says what the FMU is and lists its variables.
std::string documentation(const Unit& unit, const Facts& facts, fmi::Version version);

/// The name of a C library made of any text.
std::string identifier_of(const std::string& text);

}  // namespace tandem::exported
