// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>

namespace tandem::cli {

// In place of CLI::PositiveNumber and CLI::NonNegativeNumber, which let NaN pass.

inline const CLI::Validator positive(
    [](const std::string& text) {
      double value = 0.0;
      const bool sound = CLI::detail::lexical_cast(text, value) && value > 0.0;
      return sound ? std::string() : "'" + text + "' is given; allowed is a number above 0";
    },
    "POSITIVE");

inline const CLI::Validator not_negative(
    [](const std::string& text) {
      double value = 0.0;
      const bool sound = CLI::detail::lexical_cast(text, value) && value >= 0.0;
      return sound ? std::string() : "'" + text + "' is given; allowed is a number from 0";
    },
    "NONNEGATIVE");

}  // namespace tandem::cli
