// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "recording.hpp"

namespace tandem::test {

/// Success if two recordings hold the same rows to the last bit; else the first difference.
inline testing::AssertionResult same_bits(const std::vector<Recording::Rows>& a,
                                          const std::vector<Recording::Rows>& b) {
  if (a.size() != b.size())
    return testing::AssertionFailure() << a.size() << " and " << b.size() << " subsystems";
  for (std::size_t who = 0; who < a.size(); ++who) {
    if (a[who].size() != b[who].size())
      return testing::AssertionFailure()
             << a[who].size() << " and " << b[who].size() << " rows of subsystem " << who;
    for (std::size_t row = 0; row < a[who].size(); ++row) {
      const auto &x = a[who][row], &y = b[who][row];
      if (x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0) continue;
      auto difference = testing::AssertionFailure()
                        << "subsystem " << who << ", row " << row << " at t = " << x[0];
      for (std::size_t k = 0; k < x.size(); ++k)
        difference << "\n  " << testing::PrintToString(x[k]) << " " << testing::PrintToString(y[k]);
      return difference;
    }
  }
  return testing::AssertionSuccess();
}

}  // namespace tandem::test
