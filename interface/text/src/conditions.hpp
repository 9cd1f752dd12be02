// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem::text {

/// "(NAME is WORD)" or "(NAME in [WORD, WORD])" in an expression.
struct Condition {
  std::string name;
  std::vector<std::string> words;
  std::string stands_for;  ///< the variable that takes its place, 1 or 0
};

/// Takes the conditions of an expression out: a variable of the same length takes the place of each.
std::vector<Condition> take_conditions(std::string& expression);

}  // namespace tandem::text
