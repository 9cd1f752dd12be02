// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <sstream>
#include <string>

#include "two_mass_run.hpp"

namespace tandem::test {

/// Theory +-0.2, so that an order that drops by one fails by far.
constexpr double order_tolerance = 0.2;

/// Errors with all steps halved twice, from `coarsest` steps per cycle on.
inline std::array<GlobalError, 3> refined(TwoMassRun what, double coarsest) {
  std::array<GlobalError, 3> errors{};
  for (std::size_t k = 0; k < errors.size(); ++k) {
    what.settings.steps_per_cycle = coarsest * static_cast<double>(1 << k);
    errors[k] = error_of(run(what));
  }
  return errors;
}

inline std::string described(const TwoMassRun& what) {
  return std::string(Schedule::name(what.schedule)) + ", " + what.to_fast + " to fast, " + what.to_slow +
         " to slow, frequency ratio " + std::to_string(what.settings.frequency_ratio);
}

/// Each time the steps are halved the global error (error_of, over the whole run) of one side must fall by
/// 2^expected.
inline void expect_order(const std::array<GlobalError, 3>& errors, double GlobalError::*side,
                         double expected) {
  for (std::size_t k = 1; k < errors.size(); ++k)
    EXPECT_NEAR(order(errors[k - 1].*side, errors[k].*side), expected, order_tolerance)
        << (side == &GlobalError::fast ? "x1" : "x2") << ", error from " << errors[k - 1].*side << " to "
        << errors[k].*side;
}

/// Of both sides. `coarsest` is where the orders have settled to within half the tolerance; the finest errors
/// are still well above rounding (1e-13 m).
inline void expect_order(const TwoMassRun& what, double coarsest, double expected) {
  SCOPED_TRACE(described(what));
  const auto errors = refined(what, coarsest);
  expect_order(errors, &GlobalError::fast, expected);
  expect_order(errors, &GlobalError::slow, expected);
}

inline void expect_order_of_x1(const TwoMassRun& what, double coarsest, double expected) {
  SCOPED_TRACE(described(what));
  expect_order(refined(what, coarsest), &GlobalError::fast, expected);
}

/// For tests by schedule and frequency ratio: where orders have settled with exact sides.
struct Place {
  Schedule::Kind schedule;
  double frequency_ratio;
  double coarsest;  ///< steps per cycle

  TwoMassRun run() const { return run_at(frequency_ratio, schedule); }
};

inline void PrintTo(const Place& place, std::ostream* out) {
  *out << Schedule::name(place.schedule) << " at frequency ratio " << place.frequency_ratio;
}

inline std::string place_name(const testing::TestParamInfo<Place>& info) {
  std::ostringstream text;
  text << Schedule::name(info.param.schedule) << '_' << info.param.frequency_ratio;
  std::string name = text.str();
  for (char& c : name)
    if (c == '-' || c == '.') c = '_';
  return name;
}

}  // namespace tandem::test
