// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tandem/nearest.hpp"

namespace tandem::cli {

// What an option may be, told with what is given. The first two stand in place of CLI::PositiveNumber and
// CLI::NonNegativeNumber, which let NaN and infinity pass.

inline const CLI::Validator positive(
    [](const std::string& text) {
      double value = 0.0;
      const bool sound = CLI::detail::lexical_cast(text, value) && value > 0.0 && std::isfinite(value);
      return sound ? std::string() : "'" + text + "' is given; allowed is a number above 0";
    },
    "POSITIVE");

inline const CLI::Validator not_negative(
    [](const std::string& text) {
      double value = 0.0;
      const bool sound = CLI::detail::lexical_cast(text, value) && value >= 0.0 && std::isfinite(value);
      return sound ? std::string() : "'" + text + "' is given; allowed is a number from 0";
    },
    "NONNEGATIVE");

inline const CLI::Validator finite(
    [](const std::string& text) {
      double value = 0.0;
      const bool sound = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
      return sound ? std::string() : "'" + text + "' is given; allowed is a finite number";
    },
    "FINITE");

inline const CLI::Validator whole(
    [](const std::string& text) {
      std::uint64_t value = 0;
      const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
      return digits && CLI::detail::lexical_cast(text, value)
                 ? std::string()
                 : "'" + text + "' is given; allowed is a whole number from 0";
    },
    "WHOLE");

inline const CLI::Validator number(
    [](const std::string& text) {
      double value = 0.0;
      const bool sound = CLI::detail::lexical_cast(text, value) && !std::isnan(value);
      return sound ? std::string() : "'" + text + "' is given; allowed is a number";
    },
    "NUMBER");

/// A whole number within these.
inline CLI::Validator from_to(int least, int most) {
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  return {[=](std::string& text) {
            int value = 0;
            const bool sound = whole(text).empty() && CLI::detail::lexical_cast(text, value) &&
                               value >= least && value <= most;
            return sound ? std::string() : "'" + text + "' is given; allowed is a whole number from " + range;
          },
          range};
}

inline CLI::Validator one_of(const std::vector<std::string>& words) {
  const std::string all = listed(words);
  return {[=](std::string& text) {
            const bool sound = std::find(words.begin(), words.end(), text) != words.end();
            return sound ? std::string() : "'" + text + "' is given; allowed is " + all;
          },
          "{" + all + "}"};
}

inline const CLI::Validator threads = from_to(1, 1024);

inline const CLI::Validator named(
    [](const std::string& text) {
      return text.empty() ? std::string("no name is given; allowed is a name of one letter or more")
                          : std::string();
    },
    "");

}  // namespace tandem::cli
