// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "tandem/subsystem.h"
#include "tandem/subsystem.hpp"

namespace tandem {

/// Makes a subsystem from "key=value" pairs joined by '&', or "".
using MakeSubsystem = std::unique_ptr<Subsystem> (*)(const std::string& parameters);

/// What c_table() is made of.
struct CTable {
  using Create = tandem_status (*)(const char* parameters, void** self);
  static tandem_subsystem_api with(Create create);
  static tandem_status create(MakeSubsystem make, const char* parameters, void** self) noexcept;
};

/// The C table of functions of a subsystem that is written in C++, for a shared library (the other way round:
/// CSubsystem). Error and any other exception become a status and a sentence. The table lives for ever.
template <MakeSubsystem make>
const tandem_subsystem_api* c_table() {
  static const tandem_subsystem_api api = CTable::with(
      [](const char* parameters, void** self) { return CTable::create(make, parameters, self); });
  return &api;
}

}  // namespace tandem
