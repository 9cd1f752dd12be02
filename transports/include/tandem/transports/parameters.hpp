// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace tandem {

/// Named values for the making of a subsystem, from a scenario or a URI. Each is asked for by name and type;
/// what nobody asked for is an error, so that a misspelt parameter never passes unseen.
class Parameters {
 public:
  using Value = std::variant<double, bool, std::string>;

  void set(const std::string& name, Value value) { values_[name] = std::move(value); }
  bool has(const std::string& name) const { return values_.count(name) != 0; }

  /// The value of that name, or `otherwise`. Throws Error if it has another type (a text is read as a number
  /// or as true/false, since a URI knows only texts).
  double number(const std::string& name, double otherwise);
  bool flag(const std::string& name, bool otherwise);
  std::string text(const std::string& name, const std::string& otherwise);
  /// Numbers whose names begin with `prefix`, by what follows it.
  std::map<std::string, double> numbers(const std::string& prefix);

  /// Adds what "key=value&key=value" says, as texts. Throws Error beginning with `owner` for what is no pair
  /// and for a key that is there already.
  void read(const std::string& pairs, const std::string& owner);
  /// What nobody asked for, as "key=value&key=value"; it counts as asked for from now on. Numbers are written
  /// so that they read back as the same. Throws Error for a text that holds '&'.
  std::string rest();

  /// Throws Error that names a value nobody asked for, and the names that were asked for.
  void refuse_unused(const std::string& owner) const;

 private:
  const Value* find(const std::string& name);
  std::map<std::string, Value> values_;
  std::set<std::string> asked_;
};

/// The number of that name, or `otherwise`. Throws Error that names it unless it is above 0.
double positive(Parameters& parameters, const std::string& name, double otherwise);
/// Likewise; 0 is allowed too.
double not_negative(Parameters& parameters, const std::string& name, double otherwise);

}  // namespace tandem
