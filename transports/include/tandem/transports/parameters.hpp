// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace tandem {

/// Who may set a word of a source: the operator alone, who wrote its URI or the scenario, or also the client
/// of a server.
enum class Setter { operator_only, client };

/// A word that a source asks its parameters for, or all that begin with one: "absolute_tolerance.*".
struct Word {
  std::string name;
  Setter setter = Setter::operator_only;
};
using Words = std::vector<Word>;

/// Whether a name is that word, or begins as "prefix.*" says.
bool stands_for(const std::string& word, const std::string& name);
/// Those words, each with that setter.
Words words_by(Setter setter, std::initializer_list<const char*> names);
/// Both lists.
Words operator+(Words a, const Words& b);

/// Named values for the making of a subsystem, from a scenario, a URI or a client. The maker asks for each by
/// name and type. What nobody asked for is an error, so that a misspelt parameter never passes unseen. Once
/// words are declared, no other may be asked for, and none of the operator's is taken from a client.
class Parameters {
 public:
  using Value = std::variant<double, bool, std::string>;

  void set(const std::string& name, Value value) { values_[name] = std::move(value); }
  bool has(const std::string& name) const { return values_.count(name) != 0; }

  /// More words that may be asked for; one that is declared already stays as it was.
  void declare(const Words& words);
  /// Throws Error that names a declared word of the operator's whose value came from a client.
  void refuse_foreign(const std::string& owner) const;
  bool from_client(const std::string& name) const { return from_client_.count(name) != 0; }

  /// The value of that name, or `otherwise`. Throws Error if it has another type (a text is read as a number
  /// or as true/false, since a URI knows only texts); Error(internal) if the word is not declared.
  double number(const std::string& name, double otherwise);
  bool flag(const std::string& name, bool otherwise);
  std::string text(const std::string& name, const std::string& otherwise);
  /// What follows `prefix` in the names that begin with it.
  std::vector<std::string> names(const std::string& prefix) const;
  /// Numbers whose names begin with `prefix`, by what follows it.
  std::map<std::string, double> numbers(const std::string& prefix);

  /// Adds what "key=value&key=value" says, as texts; %26, %3D and %25 stand for &, = and %. Throws Error beginning with `owner` for what is no pair
  /// and for a key that is there already. by: whose words they are.
  void read(const std::string& pairs, const std::string& owner, Setter by = Setter::operator_only);
  /// All of them but those that are left out, as "key=value&key=value"; numbers are written so that they read back as the
  /// same.
  std::string written(const std::function<bool(const std::string& name)>& left_out) const;
  /// What nobody asked for, as "key=value&key=value"; it counts as asked for from now on. Numbers are written
  /// so that they read back as the same. Throws Error for a name or a text that would not.
  std::string rest();
  /// The same for read(), so that each name and text is allowed.
  std::string rest_escaped();

  /// Throws Error that names a value nobody asked for, and the names that somebody asked for.
  void refuse_unused(const std::string& owner) const;

 private:
  const Value* find(const std::string& name);
  std::vector<std::pair<std::string, std::string>> take_rest();
  const Word* declared(const std::string& name) const;
  std::map<std::string, Value> values_;
  std::set<std::string> asked_, from_client_;
  std::optional<Words> words_;  ///< that may be asked for; any, if none were declared
};

/// The number of that name, or `otherwise`. Throws Error that names it unless it is above 0.
double positive(Parameters& parameters, const std::string& name, double otherwise);
/// Likewise; 0 is allowed too.
double not_negative(Parameters& parameters, const std::string& name, double otherwise);

}  // namespace tandem
