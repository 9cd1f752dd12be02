// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <vector>

#include "tandem/export/system.hpp"
#include "tandem/scenario/parts.hpp"

namespace tandem::exported {

/// A subsystem of a scenario as a component of a system.
struct SystemMember {
  std::string name;
  std::string fmu;  ///< its bytes
  fmi::Description description;
  const SubsystemInfo* source = nullptr;  ///< of what became the FMU; null: it was one
  scenario::Place place = {};
  std::map<std::string, std::string> units = {};   ///< by variable, in place of the FMU's
  std::map<std::string, std::string> values = {};  ///< before the start, by variable
  std::map<std::string, std::string> annotation = {};

  /// As one that reads the system will take it: of a variable.
  std::string unit_of(const std::string& variable) const;

  /// The variables that a port is, or an element of one: "x", "x[1]". Throws Error for an element of an array
  /// of an FMU.
  std::vector<std::string> variables(const std::string& port, bool output) const;
};

/// Makes one of the entry number `k`, whose parts have been opened or looked at. folder: for files on the way.
SystemMember member_of(const scenario::Scenario& scenario, const scenario::Parts& parts, int k,
                       const SystemSettings& settings, const std::filesystem::path& folder,
                       const Builtins& here);

}  // namespace tandem::exported
