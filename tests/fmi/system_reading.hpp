// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "system_file.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::test {

using scenario::Scenario;

inline Scenario read_system(const Scratch& folder, const std::string& description,
                            const std::vector<std::string>& fmus = {"mass"},
                            const std::vector<Packed>& more = {}) {
  return scenario::read(write_system(folder, description, fmus, more));
}

/// Of a subsystem's parameter; empty: it is not given.
inline std::string given(const Scenario& s, std::size_t subsystem, const std::string& name) {
  for (const scenario::Parameter& p : s.subsystems.at(subsystem).parameters)
    if (p.name == name)
      return std::visit(
          [](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
              return value;
            else
              return std::to_string(value);
          },
          p.value);
  return "";
}

inline bool is_given(const Scenario& s, std::size_t subsystem, const std::string& name) {
  const auto& all = s.subsystems.at(subsystem).parameters;
  return std::any_of(all.begin(), all.end(), [&](const scenario::Parameter& p) { return p.name == name; });
}

inline std::string annotated(const std::string& attributes) {
  return "<ssd:Annotations><ssc:Annotation type=\"other\"/><ssc:Annotation "
         "type=\"org.tandem.coordination\"><t:x " +
         attributes + "/></ssc:Annotation></ssd:Annotations>";
}

}  // namespace tandem::test
