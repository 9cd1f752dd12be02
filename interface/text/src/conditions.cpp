// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "conditions.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

namespace tandem::text {
namespace {

/// Reads a condition from an opening bracket on.
class ConditionReader {
 public:
  ConditionReader(std::string_view text, std::size_t begin) : text_(text), at_(begin + 1) {}

  /// Nothing: another thing stands there.
  std::optional<Condition> read() {
    Condition condition{word(), {}, ""};
    const std::string how = word();
    if (how == "is") condition.words.push_back(word());
    const bool is_list = how == "in" && is('[');
    if (is_list) condition.words = list();
    const bool has_words = !condition.words.empty() && !condition.words[0].empty();
    if (condition.name.empty() || !has_words || !is(')')) return {};
    return condition;
  }
  std::size_t end() const { return at_; }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  /// Takes one letter, if it is this.
  bool is(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    return ++at_, true;
  }
  /// Up to a blank, a bracket or a comma.
  std::string word() {
    skip_blanks();
    const auto end = std::min(text_.find_first_of(" \t\r\n,()[]", at_), text_.size());
    const std::string found(text_.substr(at_, end - at_));
    at_ = end;
    return found;
  }
  std::vector<std::string> list() {
    std::vector<std::string> words;
    do words.push_back(word());
    while (is(','));
    return is(']') ? words : std::vector<std::string>();
  }

  std::string_view text_;
  std::size_t at_;
};

}  // namespace

std::vector<Condition> take_conditions(std::string& expression) {
  std::vector<Condition> conditions;
  for (std::size_t begin = 0; (begin = expression.find('(', begin)) != std::string::npos; ++begin) {
    ConditionReader reader(expression, begin);
    auto condition = reader.read();
    if (!condition) continue;
    condition->stands_for = "_." + std::to_string(conditions.size());  // no column has a dot
    std::string in_place = "(" + condition->stands_for + ")";
    in_place.resize(std::max(in_place.size(), reader.end() - begin), ' ');
    expression.replace(begin, reader.end() - begin, in_place);
    conditions.push_back(std::move(*condition));
  }
  return conditions;
}

}  // namespace tandem::text
