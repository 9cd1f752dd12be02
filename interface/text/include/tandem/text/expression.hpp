// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tandem::text {

/// A number, or a word.
using FileValue = std::variant<double, std::string>;
/// By name.
using FileValues = std::map<std::string, FileValue>;

/// The value as an error shows it: 3 or 'word'.
std::string shown(const FileValue& value);

/// Whether a name is a number in every expression.
bool is_reserved(const std::string& name);

/// An expression, compiled once (muParser): + - * / ^, comparisons, && ||, ?:, sin, sqrt, exp, min, .., _pi,
/// _e. A name stands for a number; it may have dots and an index, "motor.speed", "wheel.force[2]". Words are
/// compared in brackets: "(schedule is parallel)" and "(how in [lagrange0, lagrange1])" are 1 where they
/// hold, else 0.
class Expression {
 public:
  /// constants: numbers of them are part of the expression, and are asked for no more. Throws
  /// Error(invalid_argument) with the expression and what is wrong in it; = and a list of values are refused.
  explicit Expression(std::string text, const FileValues& constants = {});
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  const std::string& text() const;
  /// The numbers that it asks for, each once, in the order of the text.
  const std::vector<std::string>& numbers() const;
  /// The words that its conditions compare.
  const std::vector<std::string>& words() const;

  /// With values by name. Throws Error(invalid_argument) for a name that is not there, a word in place of a
  /// number, and a number in place of a word. So it does for a result that is not finite, with the values
  /// that it has.
  double value(const FileValues& values);
  /// The numbers by their order in numbers(); conditions stand as at the last value(), at first for 0. May be
  /// not finite.
  double at(std::span<const double> numbers);

 private:
  class Compiled;
  std::unique_ptr<Compiled> compiled_;
};

/// Evaluates it; each thread compiles it once. Throws as the class does.
double evaluated(const std::string& expression, const FileValues& values);
/// The numbers and words that it asks for.
std::vector<std::string> names_in(const std::string& expression);

/// What a text that begins with $ stands for: "$NAME" for the value of NAME, "$(EXPRESSION)" for a number.
/// Throws Error for a name that is not there and as evaluated() does.
FileValue referred(const std::string& text, const FileValues& values);

}  // namespace tandem::text
