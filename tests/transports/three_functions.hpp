// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "examples.hpp"

namespace tandem::test {

inline const std::string three_functions = "three_functions:" TANDEM_THREE_FUNCTIONS;
inline const std::string its_ports = "step=0.01&inputs=u:N m&outputs=x:rad=1,u_before:N m=0";

/// The old library of tests/libraries/three_functions.c.
inline std::unique_ptr<Subsystem> open_three(const std::string& parameters) {
  return open(three_functions + "?" + parameters, library_sources());
}

}  // namespace tandem::test
