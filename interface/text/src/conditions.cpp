// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "conditions.hpp"

#include <regex>

namespace tandem::text {
namespace {

std::vector<std::string> words_of(const std::string& list) {
  static const std::regex word("[^\\s,\\[\\]]+");
  std::vector<std::string> words;
  for (std::sregex_iterator it(list.begin(), list.end(), word), end; it != end; ++it)
    words.push_back(it->str());
  return words;
}

}  // namespace

std::vector<Condition> take_conditions(std::string& expression) {
  static const std::regex pattern(
      "\\(\\s*([A-Za-z_][A-Za-z0-9_.]*)\\s+(?:is\\s+([^\\s,()\\[\\]]+)|in\\s*(\\[[^\\[\\]()]*\\]))\\s*\\)");
  std::vector<Condition> conditions;
  for (std::smatch found; std::regex_search(expression, found, pattern);) {
    const std::string variable = "_c" + std::to_string(conditions.size());
    std::string in_place = "(" + variable + ")";
    in_place.resize(std::max(in_place.size(), static_cast<std::size_t>(found.length())), ' ');
    conditions.push_back({found[1], words_of(found[2].matched ? found[2] : found[3]), variable});
    expression.replace(static_cast<std::size_t>(found.position()), static_cast<std::size_t>(found.length()),
                       in_place);
  }
  return conditions;
}

}  // namespace tandem::text
