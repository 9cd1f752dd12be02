// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "mass2_library.hpp"

namespace tandem::test {

/// A program of transports/examples in Python, which runs without installing the package.
inline std::string python_program(const std::string& file) {
  return "env PYTHONPATH=" TANDEM_SOURCE_DIR "/transports/python PYTHONDONTWRITEBYTECODE=1 " TANDEM_PYTHON
         " " TANDEM_SOURCE_DIR "/transports/examples/" +
         file;
}

/// Mass 2 in Python, as a program that is started.
inline std::string python_mass2(double frequency_ratio = 30.0) {
  return "spawn:" + python_program("mass2.py") + "?" + mass2_parameters(frequency_ratio);
}

}  // namespace tandem::test
