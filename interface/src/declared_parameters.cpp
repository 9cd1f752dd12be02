// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/declared_parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse_declared(const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, sentence);
}

/// Nothing if the text is none, or not finite.
std::optional<double> number_of(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = std::from_chars(text.data(), end, number);
  const bool sound = code == std::errc{} && stopped == end && std::isfinite(number);
  return sound ? std::optional(number) : std::nullopt;
}

std::string measured_in(const DeclaredParameter& p) {
  return !p.unit ? "a word" : *p.unit == "1" ? "a finite number" : "a finite number in " + *p.unit;
}

const DeclaredParameter& find(const DeclaredParameters& declared, const std::string& name) {
  const auto it = std::find_if(declared.begin(), declared.end(),
                               [&](const DeclaredParameter& p) { return p.name == name; });
  if (it != declared.end()) return *it;
  std::vector<std::string> names;
  for (const DeclaredParameter& p : declared) names.push_back(p.name);
  refuse_declared(unknown("parameter", printable(name), names));
}

using Texts = std::map<std::string, std::string, std::less<>>;

/// What is given of the declared ones.
Texts given_of(const DeclaredParameters& declared, const std::string& pairs) {
  Texts given;
  for (std::size_t begin = 0, end; begin < pairs.size(); begin = end + 1) {
    end = std::min(pairs.find('&', begin), pairs.size());
    const std::string pair = pairs.substr(begin, end - begin);
    const auto equals = pair.find('=');
    if (equals == std::string::npos)
      refuse_declared("'" + printable(pair) + "' stands where key=value is allowed");
    const DeclaredParameter& p = find(declared, pair.substr(0, equals));
    const std::string value = pair.substr(equals + 1);
    if (p.unit && !number_of(value))
      refuse_declared("parameter '" + p.name + "' is '" + printable(value) + "'; allowed is " +
                      measured_in(p));
    if (!given.emplace(p.name, value).second) refuse_declared("parameter '" + p.name + "' is given twice");
  }
  return given;
}

void check_one(const DeclaredParameter& p) {
  if (p.name.empty() || p.name.find_first_of("=& \t\n") != std::string::npos)
    refuse_declared("a parameter is declared with the name '" + printable(p.name) +
                    "'; allowed is one without blanks, '=' and '&'");
  for (const std::string& text : {p.name, p.unit.value_or(""), p.otherwise.value_or(""), p.sentence})
    if (text.size() > longest_parameter_text)
      refuse_declared("parameter '" + printable(p.name) + "' is declared with a text of " +
                      std::to_string(text.size()) + " bytes; allowed are up to " +
                      std::to_string(longest_parameter_text));
  if (p.unit && p.otherwise && !number_of(*p.otherwise))
    refuse_declared("parameter '" + p.name + "' is declared to be '" + printable(*p.otherwise) +
                    "' where none is given; allowed is " + measured_in(p));
}

}  // namespace

DeclaredParameters declared_from(std::span<const tandem_parameter> parameters) {
  const auto text = [](const char* c) { return c ? std::optional<std::string>(c) : std::nullopt; };
  DeclaredParameters declared;
  for (const tandem_parameter& p : parameters) {
    if (!p.name || !p.sentence)
      refuse_declared("parameter " + std::to_string(&p - parameters.data()) +
                      " is declared without name or sentence");
    declared.push_back({p.name, text(p.unit), text(p.otherwise), p.sentence});
  }
  check_declared(declared);
  return declared;
}

void check_declared(const DeclaredParameters& declared) {
  if (declared.size() > most_parameters)
    refuse_declared(std::to_string(declared.size()) + " parameters are declared; allowed are up to " +
                    std::to_string(most_parameters));
  std::set<std::string_view> names;
  for (const DeclaredParameter& p : declared) {
    check_one(p);
    if (!names.insert(p.name).second) refuse_declared("parameter '" + p.name + "' is declared twice");
  }
}

void check_given(const DeclaredParameters& declared, const std::string& pairs) {
  if (!declared.empty()) given_of(declared, pairs);
}

ParameterValues::ParameterValues(const DeclaredParameters& declared, const std::string& pairs)
    : texts_(given_of(declared, pairs)) {
  for (const DeclaredParameter& p : declared) {
    if (texts_.contains(p.name)) continue;
    if (!p.otherwise)
      refuse_declared("parameter '" + p.name + "' is needed, " + measured_in(p) + ": " +
                      printable(p.sentence));
    texts_[p.name] = *p.otherwise;
  }
}

double ParameterValues::number(std::string_view name) const {
  if (const auto value = number_of(word(name))) return *value;
  throw Error(ErrorCode::internal, "parameter '" + std::string(name) + "' is not declared as a number");
}

const std::string& ParameterValues::word(std::string_view name) const {
  const auto it = texts_.find(name);
  if (it != texts_.end()) return it->second;
  throw Error(ErrorCode::internal, "parameter '" + std::string(name) + "' is not declared");
}

void throw_behind(const std::string& text, const Error& error) {
  const Error longer(error.code(), text + error.what());
  if (const auto* not_made = dynamic_cast<const NotMade*>(&error))
    throw NotMade(longer, not_made->parameters());
  throw longer;
}

}  // namespace tandem
