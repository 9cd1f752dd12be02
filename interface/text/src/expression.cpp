// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <deque>
#include <numbers>

#include "conditions.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::text {
namespace {

constexpr std::size_t longest = 1000;

[[noreturn]] void refuse_expression(const std::string& expression, const std::string& why) {
  throw Error(ErrorCode::invalid_argument, "the expression '" + expression.substr(0, longest) + "' " + why);
}

bool is_in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// muParser would assign at "=", and take the last of "1, 2". Between a function's arguments a comma stays.
void refuse_lists_and_assignments(const std::string& e) {
  std::string calls;  // of each bracket that is open, whether a function's
  for (std::size_t k = 0; k < e.size(); ++k) {
    const char before = k > 0 ? e[k - 1] : ' ', after = k + 1 < e.size() ? e[k + 1] : ' ';
    if (e[k] == '(') calls += is_in_name(before) ? 'f' : '(';
    if (e[k] == ')' && !calls.empty()) calls.pop_back();
    if (e[k] == ',' && (calls.empty() || calls.back() != 'f'))
      refuse_expression(e, "has a comma; allowed is one between a function's arguments");
    if (e[k] == '=' && after != '=' && std::string("=<>!").find(before) == std::string::npos)
      refuse_expression(e, "has a single =; allowed is ==, which compares");
  }
}

/// Of the thread, so that who evaluates one for each row of a table does not compile it again.
Expression& kept(const std::string& text) {
  constexpr std::size_t most = 1000;
  thread_local std::map<std::string, Expression> all;
  if (const auto it = all.find(text); it != all.end()) return it->second;
  if (all.size() >= most) all.clear();
  return all.emplace(text, Expression(text)).first->second;
}

/// "; numbers are k, m"; empty if there are none.
std::string known_numbers(const FileValues& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values)
    if (std::holds_alternative<double>(value)) names.push_back(name);
  return names.empty() ? "" : "; numbers are " + listed(names);
}

}  // namespace

std::string shown(const FileValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return "'" + std::get<std::string>(value) + "'";
}

bool is_reserved(const std::string& name) { return name == "_pi" || name == "_e"; }

class Expression::Compiled {
 public:
  Compiled(std::string text, const FileValues& constants) : text_(std::move(text)) {
    if (text_.size() > longest)
      refuse_expression(text_, fmt::format("goes on; allowed are {} letters", longest));
    std::string plain = text_;
    conditions_ = take_conditions(plain);
    refuse_lists_and_assignments(plain);
    parser_.DefineNameChars("0123456789_.[]abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    parser_.DefineConst("_pi", std::numbers::pi);  // muParser's own has 13 digits
    parser_.DefineConst("_e", std::numbers::e);
    for (const auto& [name, value] : constants)
      if (const auto* number = std::get_if<double>(&value)) parser_.DefineConst(name, *number);
    for (const Condition& condition : conditions_) {
      parser_.DefineVar(condition.stands_for, &holds_.emplace_back(0.0));
      words_.push_back(condition.name);
    }
    parser_.SetVarFactory(&Compiled::make, this);
    guarded([&] {
      parser_.SetExpr(plain);
      parser_.Eval();
    });
  }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;

  double at(std::span<const double> numbers) {
    std::copy(numbers.begin(), numbers.end(), values_.begin());
    return guarded([&] { return parser_.Eval(); });
  }

  double value(const FileValues& values) {
    for (std::size_t k = 0; k < names_.size(); ++k) values_[k] = number(names_[k], values);
    for (std::size_t k = 0; k < conditions_.size(); ++k)
      holds_[k] = holds(conditions_[k], values) ? 1.0 : 0.0;
    const double result = guarded([&] { return parser_.Eval(); });
    if (!std::isfinite(result))
      refuse_expression(text_,
                        fmt::format("is {}{}; allowed is a finite number", result, with_values(values)));
    return result;
  }

  const std::string text_;
  std::vector<std::string> names_, words_;

 private:
  static double* make(const char* name, void* self) {
    auto& own = *static_cast<Compiled*>(self);
    own.names_.emplace_back(name);
    return &own.values_.emplace_back(1.0);
  }

  template <class Work>
  auto guarded(const Work& work) -> decltype(work()) {
    try {
      return work();
    } catch (const mu::Parser::exception_type& error) {
      refuse_expression(text_, "can't be read at letter " + std::to_string(error.GetPos() + 1) +
                                   "; allowed are as in 2*(a + 1)^2 < b && c is WORD");
    }
  }

  double number(const std::string& name, const FileValues& values) const {
    const auto it = values.find(name);
    if (it == values.end())
      refuse_expression(text_, fmt::format("can't be read at letter {}, for '{}' is not there{}",
                                           text_.find(name) + 1, name, known_numbers(values)));
    if (const auto* number = std::get_if<double>(&it->second)) return *number;
    refuse_expression(text_,
                      fmt::format("has {}, which is the word {}; allowed is a number, and to compare words "
                                  "({} is WORD)",
                                  name, shown(it->second), name));
  }

  bool holds(const Condition& condition, const FileValues& values) const {
    const auto it = values.find(condition.name);
    if (it == values.end())
      refuse_expression(text_, fmt::format("compares {}, which is not there", condition.name));
    const auto* word = std::get_if<std::string>(&it->second);
    if (!word)
      refuse_expression(
          text_, fmt::format("compares {} with a word, but it is the number {}; allowed is {} == NUMBER",
                             condition.name, shown(it->second), condition.name));
    return std::find(condition.words.begin(), condition.words.end(), *word) != condition.words.end();
  }

  std::string with_values(const FileValues& values) const {
    std::string text;
    for (const auto* names : {&names_, &words_})
      for (const std::string& name : *names) text += fmt::format(", {} = {}", name, shown(values.at(name)));
    return text;
  }

  mu::Parser parser_;
  std::vector<Condition> conditions_;
  std::deque<double> values_, holds_;  ///< where the parser reads them
};

Expression::Expression(std::string text, const FileValues& constants)
    : compiled_(std::make_unique<Compiled>(std::move(text), constants)) {}
Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
const std::string& Expression::text() const { return compiled_->text_; }
const std::vector<std::string>& Expression::numbers() const { return compiled_->names_; }
const std::vector<std::string>& Expression::words() const { return compiled_->words_; }
double Expression::value(const FileValues& values) { return compiled_->value(values); }
double Expression::at(std::span<const double> numbers) { return compiled_->at(numbers); }

double evaluated(const std::string& expression, const FileValues& values) {
  return kept(expression).value(values);
}

std::vector<std::string> names_in(const std::string& expression) {
  std::vector<std::string> names = kept(expression).numbers();
  const auto& words = kept(expression).words();
  names.insert(names.end(), words.begin(), words.end());
  return names;
}

FileValue referred(const std::string& text, const FileValues& values) {
  const std::string rest = text.substr(1);
  if (rest.starts_with("(") && !rest.ends_with(")"))
    throw Error(ErrorCode::invalid_argument, "'" + text + "' is no expression in brackets; allowed is $(..)");
  if (rest.starts_with("(")) return evaluated(rest.substr(1, rest.size() - 2), values);
  if (const auto it = values.find(rest); it != values.end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [name, value] : values) known.push_back(name);
  throw Error(ErrorCode::invalid_argument, unknown("parameter", rest, known));
}

}  // namespace tandem::text
