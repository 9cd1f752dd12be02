// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tandem/error.hpp"

namespace tandem::test {

/// Success if `action` throws Error of that code, with a sentence that holds each of the texts:
/// EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"fast.x2", "-1"}, [&] { ... })).
template <class Action>
testing::AssertionResult refuses(ErrorCode code, const std::vector<std::string>& texts, Action&& action) {
  try {
    action();
  } catch (const Error& e) {
    const std::string sentence = e.what();
    if (e.code() != code)
      return testing::AssertionFailure() << "code " << static_cast<int>(e.code()) << " of: " << sentence;
    for (const std::string& text : texts)
      if (sentence.find(text) == std::string::npos)
        return testing::AssertionFailure() << "no '" << text << "' in: " << sentence;
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "nothing was thrown";
}

}  // namespace tandem::test
