// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <iterator>
#include <memory>
#include <span>
#include <string>

#include "tandem/declared_parameters.hpp"
#include "tandem/subsystem.h"
#include "tandem/subsystem.hpp"

namespace tandem {

/// Makes a subsystem from "key=value" pairs joined by '&', or "".
using MakeSubsystem = std::unique_ptr<Subsystem> (*)(const std::string& parameters);
/// Makes one from declared parameters.
using MakeFromValues = std::unique_ptr<Subsystem> (*)(const ParameterValues& parameters);

/// What c_table() is made of.
struct CTable {
  using Create = tandem_status (*)(const char* parameters, void** self);
  static tandem_subsystem_api with(Create create);
  static tandem_status create(MakeSubsystem make, const char* parameters, void** self) noexcept;
  static tandem_status create(MakeFromValues make, std::span<const tandem_parameter> declared,
                              const char* parameters, void** self) noexcept;
};

/// The C table of functions of a subsystem that is written in C++, for a shared library (the other way round:
/// CSubsystem). Error and any other exception become a status and a sentence. The table lives for ever.
template <MakeSubsystem make>
const tandem_subsystem_api* c_table() {
  static const tandem_subsystem_api api = CTable::with(
      [](const char* parameters, void** self) { return CTable::create(make, parameters, self); });
  return &api;
}

/// The same of a kind that declares its parameters, an array that lives for ever:
/// @code
/// constexpr tandem_parameter parameters[] = {{"m", "kg", nullptr, "mass"}, {"h", "s", "1e-3", "own step"}};
/// @endcode
template <MakeFromValues make, const auto& parameters>
const tandem_subsystem_api* c_table() {
  static const tandem_subsystem_api api = [] {
    tandem_subsystem_api table = CTable::with(
        [](const char* text, void** self) { return CTable::create(make, parameters, text, self); });
    table.parameters = [](std::int32_t* count) {
      *count = static_cast<std::int32_t>(std::size(parameters));
      return std::data(parameters);
    };
    return table;
  }();
  return &api;
}

}  // namespace tandem
