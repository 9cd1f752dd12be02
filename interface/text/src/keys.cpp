// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

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

/// NAME is any name, or left out.
bool matches(std::vector<std::string> pattern, const std::vector<std::string>& path) {
  const bool whole =
      std::equal(pattern.begin(), pattern.end(), path.begin(), path.end(),
                 [](const std::string& a, const std::string& b) { return a == "NAME" || a == b; });
  std::erase(pattern, "NAME");
  return whole || pattern == path;
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

bool contains(const std::vector<std::string>& all, std::string_view one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

std::string in_marks(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

bool holds_keys(const Key& key) { return key.type >= Key::Type::table && key.type <= Key::Type::tables; }

/// "a, b or c".
std::string words_of(const Key& key) {
  std::string all;
  const auto count = key.words.size();
  for (std::size_t k = 0; k < count; ++k)
    all += (k == 0 ? "" : k + 1 == count && key.allowed.empty() ? " or " : ", ") + in_marks(key.words[k]);
  return all;
}

}  // namespace

bool Key::allows(const std::string& word) const { return contains(words, word) || (also && also(word)); }

/// With marks of Markdown around words.
static std::string marked(const Key& key) {
  static constexpr const char* names[] = {"a text",
                                          "a word",
                                          "a number",
                                          "a number above 0",
                                          "true or false",
                                          "an array of texts",
                                          "a number, true, false or a text",
                                          "a number, true, false, a text, an array or a table of these",
                                          "a number, or an array of numbers",
                                          "an array of numbers",
                                          "a table of numbers",
                                          "a number, or an array of arrays of numbers",
                                          "a number or a text",
                                          "a signal, or a number",
                                          "an array of signals and numbers",
                                          "a text, or an array of texts",
                                          "an array of texts, or of arrays of texts",
                                          "a table",
                                          "a number, an array of numbers, or a table",
                                          "an array of tables",
                                          "a table with what a file has",
                                          ""};
  static_assert(std::size(names) == static_cast<std::size_t>(Key::Type::any) + 1);
  std::string all = names[static_cast<std::size_t>(key.type)];
  if (key.type == Key::Type::word) all = words_of(key);
  if (!key.unit.empty()) all += " [" + key.unit + "]";
  if (!key.allowed.empty())
    all += (all.empty() ? "" : key.type == Key::Type::word ? ", or " : ", ") + key.allowed;
  return all;
}

std::string described(const Key& key) {
  std::string all = marked(key);
  std::erase(all, '`');
  return all;
}

std::string name_of(const Key& key) { return parts(key.path).back(); }

static std::string row(const Key& key) {
  return fmt::format("| `{}` | {} | {} | {} |\n", name_of(key), marked(key),
                     key.required ? "refused" : in_marks(key.otherwise), key.sentence);
}

static std::string rows(const std::vector<const Key*>& keys) {
  if (keys.empty()) return "";
  std::string all = "\n| key | value | where it is not there | meaning |\n|---|---|---|---|\n";
  for (const Key* key : keys) all += row(*key);
  return all;
}

Keys::Keys(std::vector<Key> keys, Texts texts) : keys_(std::move(keys)), texts_(texts) {
  for (std::size_t k = 0; k < keys_.size(); ++k) by_path_.emplace(keys_[k].path, k);
}

const Key* Keys::find(std::string_view path, std::string_view kind) const {
  const auto [begin, end] = by_path_.equal_range(path);
  for (auto it = begin; it != end; ++it)
    if (const Key& key = keys_[it->second]; key.kinds.empty() || contains(key.kinds, kind)) return &key;
  return nullptr;
}

std::vector<const Key*> Keys::in(std::string_view table, std::string_view kind) const {
  std::vector<const Key*> all;
  for (const Key& key : keys_)
    if (table_of(key.path) == table && (key.kinds.empty() || contains(key.kinds, kind))) all.push_back(&key);
  return all;
}

std::vector<const Key*> Keys::kinds(std::string_view table) const {
  std::vector<const Key*> all;
  const auto [begin, end] = by_path_.equal_range(table);
  for (auto it = begin; it != end; ++it)
    if (!keys_[it->second].kinds.empty()) all.push_back(&keys_[it->second]);
  return all;
}

/// Whether a key is there in a table that a user calls so: by one of its kinds, or by any name.
bool Keys::may_be_in(const Key& key, const std::vector<std::string>& asked) const {
  if (key.kinds.empty()) return true;
  const auto table = key.type == Key::Type::table && !kinds(key.path).empty() ? key.path : table_of(key.path);
  const std::size_t place = parts(table).size() - 1;
  const std::string name = place < asked.size() ? asked[place] : "";
  const auto all = kinds(table);
  const bool is_kind =
      std::any_of(all.begin(), all.end(), [&](const Key* kind) { return kind->kinds[0] == name; });
  return !is_kind || contains(key.kinds, name);
}

std::vector<const Key*> Keys::matching(const std::string& path) const {
  const auto asked = parts(path);
  std::vector<const Key*> all;
  for (const Key& key : keys_)
    if (matches(parts(key.path), asked) && may_be_in(key, asked)) all.push_back(&key);
  // Of a name that is there, and of what holds for all kinds or for that one alone, there is no other.
  const auto keep = [&all](const auto& better) {
    if (std::any_of(all.begin(), all.end(), better)) std::erase_if(all, std::not_fn(better));
  };
  keep([&](const Key* key) { return name_of(*key) == asked.back(); });
  keep([&](const Key* key) { return contains(key->kinds, asked.back()); });
  keep([&](const Key* key) {
    return key->type != Key::Type::table || key->kinds.empty() || contains(key->kinds, asked.back());
  });
  return all;
}

void Keys::refuse(const std::string& path) const {
  auto asked = parts(path);
  while (!asked.empty()) {
    const std::string last = asked.back();
    asked.pop_back();
    const auto tables = matching(fmt::format("{}", fmt::join(asked, ".")));
    const Key* const table = tables.empty() ? nullptr : tables[0];
    if (!asked.empty() && (!table || !holds_keys(*table))) continue;
    std::vector<std::string> known;
    for (const Key* key : in(table ? table->path : "", table && !table->kinds.empty() ? table->kinds[0] : ""))
      known.push_back(name_of(*key));
    throw Error(ErrorCode::invalid_argument,
                unknown(asked.empty() ? "key" : "key of " + header(*table), last, known));
  }
  throw Error(ErrorCode::invalid_argument, "a key is needed, like " + keys_.front().path);
}

/// [subsystems], which has tables by name and nothing else.
bool Keys::holds_tables_alone(const Key& table) const {
  const Key* const inner = find(table.path + ".NAME");
  return inner && inner->type == Key::Type::table;
}

std::string Keys::titled(const Key& table) const {
  std::string all = fmt::format("\n## `{}`\n\n{}\n{}", header(table), table.sentence, rows(in(table.path)));
  for (const Key* kind : kinds(table.path)) {
    auto own = in(table.path, kind->kinds[0]);
    std::erase_if(own, [](const Key* key) { return key->kinds.empty(); });
    all += fmt::format("\n### `{}` of kind `{}`\n\n{}\n{}", header(table), kind->kinds[0], kind->sentence,
                       rows(own));
  }
  return all;
}

std::string Keys::page() const {
  std::string all =
      "## The file\n\nKeys outside of any table, and the tables that there are.\n" + rows(in(""));
  for (const Key& key : keys_) {
    const bool is_kind = find(key.path) != &key && !kinds(key.path).empty();
    if (holds_keys(key) && !is_kind && !holds_tables_alone(key)) all += titled(key);
  }
  return all;
}

}  // namespace tandem::text
