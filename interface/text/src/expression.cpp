// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <muParser.h>

#include <cctype>
#include <cmath>
#include <numbers>

#include "tandem/error.hpp"
#include "tandem/text/values.hpp"

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

bool is_name(const std::string& name) {
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0) return false;
  for (const char c : name)
    if (!is_in_name(c)) return false;
  return true;
}

std::string with_values(const mu::Parser& parser) {
  std::string text;
  for (const auto& [name, value] : parser.GetUsedVar()) text += fmt::format(", {} = {}", name, *value);
  return text;
}

}  // namespace

double evaluated(const std::string& expression, const std::map<std::string, FileValue>& values) {
  if (expression.size() > longest)
    refuse_expression(expression, fmt::format("goes on; allowed are {} letters", longest));
  refuse_lists_and_assignments(expression);
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : values)
    if (const auto* number = std::get_if<double>(&value); number && is_name(name)) numbers[name] = *number;
  try {
    mu::Parser parser;
    parser.DefineConst("_pi", std::numbers::pi);  // muParser's own has 13 digits
    parser.DefineConst("_e", std::numbers::e);
    for (auto& [name, number] : numbers) parser.DefineVar(name, &number);
    parser.SetExpr(expression);
    const double result = parser.Eval();
    if (!std::isfinite(result))
      refuse_expression(expression,
                        fmt::format("is {}{}; allowed is a finite number", result, with_values(parser)));
    return result;
  } catch (const mu::Parser::exception_type& error) {
    std::string known;
    for (const auto& [name, number] : numbers) known += (known.empty() ? "; numbers are " : ", ") + name;
    refuse_expression(expression, "can't be read at letter " + std::to_string(error.GetPos() + 1) + known);
  }
}

}  // namespace tandem::text
