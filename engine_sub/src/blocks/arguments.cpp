// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compile/refuse.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

std::string described(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("the number {}", *number);
  if (const auto* text = std::get_if<std::string>(&value)) return "the text '" + *text + "'";
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  return fmt::format("an array of {}", std::get<std::vector<Wire>>(value).size());
}

/// What holds without the key, as its language has it.
Value otherwise(const text::Key& key) {
  if (key.type == text::Key::Type::flag) return key.otherwise == "true";
  if (key.type == text::Key::Type::word || key.type == text::Key::Type::text) return key.otherwise;
  return std::stod(key.otherwise);
}

}  // namespace

Arguments::Arguments(const Block& block, Lowering& to, const text::Keys* language, std::string table)
    : block_(block), to_(to), language_(language), table_(std::move(table)) {}

/// As the language has it; null for a compiled kind. A key of any name stands for those of others.
const text::Key* Arguments::known(const std::string& key) const {
  if (!language_) return nullptr;
  for (const std::string& name : {key, key + "[]", std::string("NAME")})
    if (const auto* found = language_->find(table_ + "." + name, block_.kind)) return found;
  throw std::logic_error("key '" + key + "' of " + table_ + ", kind " + block_.kind +
                         ", is read and stands in no list of keys");
}

const Value* Arguments::find(const std::string& key) {
  const text::Key* const of = known(key);
  asked_.insert(key);
  if (block_.tables.contains(key))
    refuse(key, "a table", of ? text::described(*of) : "a signal, or a number");
  const auto it = block_.values.find(key);
  return it == block_.values.end() ? nullptr : &it->second;
}

Value Arguments::required(const std::string& key, const std::string& allowed) {
  if (const Value* value = find(key)) return *value;
  const text::Key* const known = this->known(key);
  if (known && !known->otherwise.empty()) return otherwise(*known);
  engine::refuse(block_.where,
                 owner() + " has no " + key + "; allowed is " + (known ? text::described(*known) : allowed));
}

void Arguments::refuse(const std::string& key, const std::string& found, const std::string& allowed) const {
  engine::refuse(block_.place(key), owner() + ": " + key + " is " + found + "; allowed is " + allowed);
}

int Arguments::slot(const std::string& key, const Wire& wire) {
  if (const auto* number = std::get_if<double>(&wire)) return to_.constant(*number);
  return to_.named(std::get<std::string>(wire), block_.place(key));
}

int Arguments::wire(const std::string& key) {
  const Value value = required(key, "the name of a signal, or a number");
  if (const auto* text = std::get_if<std::string>(&value)) return slot(key, *text);
  if (const auto* number = std::get_if<double>(&value)) return slot(key, *number);
  refuse(key, described(value), "the name of a signal, or a number");
}

std::vector<int> Arguments::wires(const std::string& key) {
  const std::string allowed = "an array with the names of signals";
  const Value value = required(key, allowed);
  const auto* list = std::get_if<std::vector<Wire>>(&value);
  if (!list || list->empty()) refuse(key, described(value), allowed);
  std::vector<int> all;
  for (const Wire& wire : *list) all.push_back(slot(key, wire));
  return all;
}

double Arguments::number(const std::string& key) {
  const Value value = required(key, "a number");
  const auto* number = std::get_if<double>(&value);
  if (!number || (has(key) && !std::isfinite(*number))) refuse(key, described(value), "a finite number");
  return *number;
}

double Arguments::positive(const std::string& key) {
  const double value = number(key);
  if (!(value > 0.0)) refuse(key, fmt::format("{}", value), "a number above 0");
  return value;
}

std::vector<double> Arguments::numbers(const std::string& key) {
  const Value value = required(key, "an array of numbers");
  if (const auto* number = std::get_if<double>(&value)) return {*number};
  const auto* list = std::get_if<std::vector<Wire>>(&value);
  if (!list || list->empty()) refuse(key, described(value), "an array of numbers");
  std::vector<double> all;
  for (const Wire& item : *list) {
    const auto* number = std::get_if<double>(&item);
    if (!number || !std::isfinite(*number)) refuse(key, "not made of finite numbers", "an array of numbers");
    all.push_back(*number);
  }
  return all;
}

std::string Arguments::text(const std::string& key) {
  const Value value = required(key, "a text");
  const auto* text = std::get_if<std::string>(&value);
  if (!text) refuse(key, described(value), "a text");
  return *text;
}

std::vector<std::string> Arguments::texts(const std::string& key) {
  const std::string allowed = "an array of names, each there once";
  const Value value = required(key, allowed);
  const auto* list = std::get_if<std::vector<Wire>>(&value);
  if (!list || list->empty()) refuse(key, described(value), allowed);
  std::vector<std::string> all;
  for (const Wire& item : *list) {
    const auto* text = std::get_if<std::string>(&item);
    if (!text || std::find(all.begin(), all.end(), *text) != all.end())
      refuse(key, text ? "an array with '" + *text + "' twice" : "not made of names", allowed);
    all.push_back(*text);
  }
  return all;
}

const std::vector<Block>& Arguments::tables(const std::string& key) {
  static const std::vector<Block> none;
  known(key);
  asked_.insert(key);
  const auto it = block_.tables.find(key);
  return it == block_.tables.end() ? none : it->second;
}

std::size_t Arguments::word(const std::string& key) {
  const std::string found = text(key);
  const auto& allowed = known(key)->words;
  const auto it = std::find(allowed.begin(), allowed.end(), found);
  if (it == allowed.end()) refuse(key, "'" + found + "'", listed(allowed));
  return static_cast<std::size_t>(it - allowed.begin());
}

bool Arguments::flag(const std::string& key) {
  const Value value = required(key, "true or false");
  const auto* flag = std::get_if<bool>(&value);
  if (!flag) refuse(key, described(value), "true or false");
  return *flag;
}

void Arguments::refuse_unknown() const {
  for (const auto& [key, value] : block_.values) refuse_unread(key);
  for (const auto& [key, tables] : block_.tables) refuse_unread(key);
}

/// A key of the kind that is not read has no meaning beside the others that are there.
void Arguments::refuse_unread(const std::string& key) const {
  if (asked_.count(key) != 0) return;
  const std::vector<std::string> read(asked_.begin(), asked_.end());
  const bool is_known = language_ && language_->find(table_ + "." + key, block_.kind);
  engine::refuse(
      block_.place(key),
      owner() + ": " +
          (is_known ? "key '" + key + "' has no meaning beside the others; read are " + listed(read)
                    : unknown("key", key, read)));
}

}  // namespace tandem::engine
