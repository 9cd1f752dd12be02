// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/parameters.hpp"

#include <algorithm>
#include <charconv>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem {
namespace {

std::string text_of(const Parameters::Value& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, std::get<double>(value)).ptr};
}

/// What stands for a sign that pairs are made of.
struct Escape {
  const char* text;
  char sign;
};
constexpr Escape escapes[] = {{"%26", '&'}, {"%3D", '='}, {"%25", '%'}};

std::string unescaped(const std::string& text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto* const found = std::find_if(std::begin(escapes), std::end(escapes), [&](const Escape& one) {
      return text.compare(at, 3, one.text) == 0;
    });
    plain += found == std::end(escapes) ? text[at] : found->sign;
    if (found != std::end(escapes)) at += 2;
  }
  return plain;
}

std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text) {
    const auto* const found = std::find_if(std::begin(escapes), std::end(escapes),
                                           [c](const Escape& one) { return one.sign == c; });
    all += found == std::end(escapes) ? std::string(1, c) : std::string(found->text);
  }
  return all;
}

/// Whether it reads back as the same without any.
bool is_plain(const std::string& text, const char* signs) {
  return text.find_first_of(signs) == std::string::npos && unescaped(text) == text;
}

[[noreturn]] void refuse(const std::string& name, double value, const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument,
              "parameter '" + name + "' is " + text_of(value) + "; allowed is a number " + allowed);
}

[[noreturn]] void wrong_type(const std::string& name, const Parameters::Value& value,
                             const std::string& allowed) {
  const bool is_text = std::holds_alternative<std::string>(value);
  throw Error(ErrorCode::invalid_argument, "parameter '" + name + "' is " +
                                               (is_text ? "'" + text_of(value) + "'" : text_of(value)) +
                                               "; " + allowed + " is allowed");
}

}  // namespace

bool stands_for(const std::string& word, const std::string& name) {
  return word.ends_with(".*") ? name.starts_with(word.substr(0, word.size() - 1)) : word == name;
}

Words words_by(Setter setter, std::initializer_list<const char*> names) {
  Words all;
  for (const char* name : names) all.push_back({name, setter});
  return all;
}

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void Parameters::declare(const Words& words) {
  if (!words_) words_.emplace();
  for (const Word& word : words)
    if (!declared(word.name)) words_->push_back(word);
}

const Word* Parameters::declared(const std::string& name) const {
  const auto it = std::find_if(words_->begin(), words_->end(),
                               [&](const Word& word) { return stands_for(word.name, name); });
  return it == words_->end() ? nullptr : &*it;
}

void Parameters::refuse_foreign(const std::string& owner) const {
  std::vector<std::string> allowed;
  for (const Word& word : *words_)
    if (word.setter == Setter::client) allowed.push_back(word.name);
  for (const std::string& name : from_client_)
    if (const Word* word = declared(name); word && word->setter == Setter::operator_only)
      throw Error(ErrorCode::invalid_argument,
                  owner + ": parameter '" + name +
                      "' comes from a client, and only who serves the source may set it; allowed to a client "
                      "are the model's own parameters" +
                      (allowed.empty() ? "" : " and " + listed(allowed)));
}

void Parameters::read(const std::string& pairs, const std::string& owner, Setter by) {
  const std::string all = pairs + "&";
  for (std::size_t begin = 0, end; (end = all.find('&', begin)) != std::string::npos; begin = end + 1) {
    const std::string pair = all.substr(begin, end - begin);
    const auto equals = pair.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Error(ErrorCode::invalid_argument, owner + " has '" + pair + "' where key=value is allowed");
    const std::string name = unescaped(pair.substr(0, equals));
    if (has(name)) throw Error(ErrorCode::invalid_argument, owner + " gives '" + name + "' twice");
    set(name, unescaped(pair.substr(equals + 1)));
    if (by == Setter::client) from_client_.insert(name);
  }
}

std::string Parameters::written(const std::function<bool(const std::string&)>& left_out) const {
  std::string pairs;
  for (const auto& [name, value] : values_)
    if (!left_out(name)) pairs += (pairs.empty() ? "" : "&") + name + "=" + text_of(value);
  return pairs;
}

std::vector<std::pair<std::string, std::string>> Parameters::take_rest() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [name, value] : values_)
    if (asked_.insert(name).second) all.emplace_back(name, text_of(value));
  return all;
}

std::string Parameters::rest_escaped() {
  std::string pairs;
  for (const auto& [name, text] : take_rest())
    pairs += (pairs.empty() ? "" : "&") + escaped(name) + "=" + escaped(text);
  return pairs;
}

std::string Parameters::rest() {
  std::string pairs;
  for (const auto& [name, text] : take_rest()) {
    if (!is_plain(text, "&") || !is_plain(name, "&="))
      throw Error(
          ErrorCode::invalid_argument,
          "parameter '" + name + "' is the text '" + text +
              "'; a name without '&' and '=', a text without '&', and both without %25, %26 and %3D are "
              "allowed here");
    pairs += (pairs.empty() ? "" : "&") + name + "=" + text;
  }
  return pairs;
}

const Parameters::Value* Parameters::find(const std::string& name) {
  if (words_ && !declared(name))
    throw Error(ErrorCode::internal,
                "parameter '" + name + "' is asked for by a source that does not declare it");
  asked_.insert(name);
  const auto it = values_.find(name);
  return it == values_.end() ? nullptr : &it->second;
}

double Parameters::number(const std::string& name, double otherwise) {
  const Value* value = find(name);
  if (!value) return otherwise;
  if (const double* number = std::get_if<double>(value)) return *number;
  if (const auto* text = std::get_if<std::string>(value)) {
    double number = 0.0;
    const auto [end, code] = std::from_chars(text->data(), text->data() + text->size(), number);
    if (code == std::errc{} && end == text->data() + text->size()) return number;
  }
  wrong_type(name, *value, "a number");
}

bool Parameters::flag(const std::string& name, bool otherwise) {
  const Value* value = find(name);
  if (!value) return otherwise;
  if (const bool* flag = std::get_if<bool>(value)) return *flag;
  if (const auto* text = std::get_if<std::string>(value); text && (*text == "true" || *text == "false"))
    return *text == "true";
  wrong_type(name, *value, "true or false");
}

std::string Parameters::text(const std::string& name, const std::string& otherwise) {
  const Value* value = find(name);
  if (!value) return otherwise;
  if (const auto* text = std::get_if<std::string>(value)) return *text;
  wrong_type(name, *value, "a text");
}

std::vector<std::string> Parameters::names(const std::string& prefix) const {
  std::vector<std::string> found;
  for (const auto& [name, value] : values_)
    if (name.starts_with(prefix)) found.push_back(name.substr(prefix.size()));
  return found;
}

std::map<std::string, double> Parameters::numbers(const std::string& prefix) {
  std::map<std::string, double> found;
  for (const std::string& name : names(prefix)) found[name] = number(prefix + name, 0.0);
  return found;
}

void Parameters::refuse_unused(const std::string& owner) const {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [name, value] : values_) {
    if (asked_.count(name)) continue;
    throw Error(ErrorCode::invalid_argument, unknown(owner + ": parameter", name, known));
  }
}

double positive(Parameters& parameters, const std::string& name, double otherwise) {
  const double value = parameters.number(name, otherwise);
  if (!(value > 0.0)) refuse(name, value, "above 0");
  return value;
}

double not_negative(Parameters& parameters, const std::string& name, double otherwise) {
  const double value = parameters.number(name, otherwise);
  if (!(value >= 0.0)) refuse(name, value, "from 0");
  return value;
}

}  // namespace tandem
