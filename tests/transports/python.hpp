// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "mass2_library.hpp"

namespace tandem::test {

/// A program in Python, which runs without installing the package.
inline std::string python_program(const std::string& file,
                                  const std::string& folder = TANDEM_SOURCE_DIR "/transports/examples/") {
  return "env PYTHONPATH=" TANDEM_SOURCE_DIR "/transports/python PYTHONDONTWRITEBYTECODE=1 " TANDEM_PYTHON
         " " +
         folder + file;
}

/// Mass 2 in Python, as a program that is started.
inline std::string python_mass2(double frequency_ratio = 30.0) {
  return "spawn:" + python_program("mass2.py") + "?" + mass2_parameters(frequency_ratio);
}

}  // namespace tandem::test
