// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>

#include "tandem/fmi/xml.hpp"

namespace tandem::fmi {

/// The units that a file defines (UnitDefinitions of FMI, Units of SSP), as tandem writes them, by their names
/// there. What has no base units stays as it is called.
std::map<std::string, std::string> read_units(const Xml& xml, pugi::xml_node definitions);

/// A unit of FMI or SSP as tandem writes it, "N m" for "N.m", "m/s^2" for "m/s2"; of `defined` what they say.
std::string unit_in(const std::string& name, const std::map<std::string, std::string>& defined);

}  // namespace tandem::fmi
