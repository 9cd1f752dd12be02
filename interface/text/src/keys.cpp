// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::text {
namespace {

/// "connections[2].gain" in parts: "connections", "gain".
std::vector<std::string> parts(std::string_view path) {
  std::vector<std::string> all;
  while (!path.empty()) {
    const auto dot = path.find('.');
    const auto part = path.substr(0, dot);
    all.emplace_back(part.substr(0, part.find('[')));
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  return all;
}

bool matches(const std::vector<std::string>& pattern, const std::vector<std::string>& path) {
  return std::equal(pattern.begin(), pattern.end(), path.begin(), path.end(),
                    [](const std::string& a, const std::string& b) { return a == "NAME" || a == b; });
}

std::string_view table_of(std::string_view path) {
  const auto dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::string header(const Key& key) {
  std::string name;
  for (const std::string& part : parts(key.path)) name += (name.empty() ? "" : ".") + part;
  return key.type == Key::Type::tables ? "[[" + name + "]]" : "[" + name + "]";
}

std::string in_marks(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

bool holds_keys(const Key& key) { return key.type == Key::Type::table || key.type == Key::Type::tables; }

/// "a, b or c".
std::string words_of(const Key& key) {
  std::string all;
  const auto count = key.words.size();
  for (std::size_t k = 0; k < count; ++k)
    all += (k == 0 ? "" : k + 1 == count && key.allowed.empty() ? " or " : ", ") + in_marks(key.words[k]);
  return all;
}

}  // namespace

bool Key::allows(const std::string& word) const {
  return std::find(words.begin(), words.end(), word) != words.end() || (also && also(word));
}

/// With marks of Markdown around words.
static std::string marked(const Key& key) {
  static constexpr const char* names[] = {"a text",
                                          "a word",
                                          "a number",
                                          "a number above 0",
                                          "true or false",
                                          "an array of texts",
                                          "a number, true, false or a text",
                                          "a number, or an array of numbers",
                                          "a number or a text",
                                          "a table",
                                          "an array of tables"};
  std::string all = names[static_cast<std::size_t>(key.type)];
  if (key.type == Key::Type::word) all = words_of(key);
  if (!key.unit.empty()) all += " [" + key.unit + "]";
  if (!key.allowed.empty()) all += (key.type == Key::Type::word ? ", or " : ", ") + key.allowed;
  return all;
}

std::string described(const Key& key) {
  std::string all = marked(key);
  std::erase(all, '`');
  return all;
}

static std::string row(const Key& key) {
  const auto name = parts(key.path).back();
  return fmt::format("| `{}` | {} | {} | {} |\n", name, marked(key),
                     key.required ? "refused" : in_marks(key.otherwise), key.sentence);
}

const Key* Keys::find(std::string_view path) const {
  const auto it = std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.path == path; });
  return it == keys_.end() ? nullptr : &*it;
}

std::vector<std::string> Keys::in(std::string_view table) const {
  std::vector<std::string> names;
  for (const Key& key : keys_)
    if (table_of(key.path) == table) names.push_back(parts(key.path).back());
  return names;
}

const Key& Keys::named(const std::string& path) const {
  auto asked = parts(path);
  if (const Key* key = matching(asked)) return *key;
  while (!asked.empty()) {
    const std::string last = asked.back();
    asked.pop_back();
    const Key* const table = matching(asked);
    if (asked.empty() || (table && holds_keys(*table)))
      throw Error(ErrorCode::invalid_argument, unknown(asked.empty() ? "key" : "key of " + header(*table),
                                                       last, in(table ? table->path : "")));
  }
  throw Error(ErrorCode::invalid_argument, "a key is needed, like " + keys_.front().path);
}

const Key* Keys::matching(const std::vector<std::string>& path) const {
  const auto it =
      std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return matches(parts(k.path), path); });
  return it == keys_.end() ? nullptr : &*it;
}

/// [subsystems], which has tables by name and nothing else.
bool Keys::holds_tables_alone(const Key& table) const {
  const Key* const inner = find(table.path + ".NAME");
  return inner && inner->type == Key::Type::table;
}

std::string Keys::page() const {
  std::string all;
  const auto add = [&](const std::string& title, const std::string& sentence, std::string_view table) {
    std::string rows;
    for (const Key& key : keys_)
      if (table_of(key.path) == table) rows += row(key);
    all += fmt::format("{}## {}\n\n{}\n", all.empty() ? "" : "\n", title, sentence);
    if (!rows.empty())
      all += "\n| key | value | where it is not there | meaning |\n|---|---|---|---|\n" + rows;
  };
  add("The file", "Keys outside of any table, and the tables that there are.", "");
  for (const Key& key : keys_)
    if (holds_keys(key) && !holds_tables_alone(key)) add("`" + header(key) + "`", key.sentence, key.path);
  return all;
}

}  // namespace tandem::text
