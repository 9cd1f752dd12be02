// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace tandem::text {

/// A key of a language of files: what its files are read by, and its page, its schema and its help are made
/// from.
struct Key {
  enum class Type {
    text,
    word,  ///< one of `words`, or of those of `pattern`
    number,
    positive,  ///< a number above 0
    flag,
    texts,
    value,    ///< a number, a flag or a text
    numbers,  ///< a number, or an array of them
    name,     ///< a number or a text
    table,
    tables,  ///< an array of tables
  };
  /// "coordination.order"; NAME stands for any name, and [] for each of an array of tables.
  std::string path;
  Type type;
  std::string sentence;        ///< its meaning
  std::string unit = {};       ///< SI; empty: none
  std::string otherwise = {};  ///< the value that holds where the key is not there; empty: none
  std::string allowed = {};    ///< what an error and the page say is allowed besides
  bool required = false;
  std::vector<std::string> words = {};
  std::string pattern = {};                    ///< a regular expression of further words, for the schema
  bool (*also)(const std::string&) = nullptr;  ///< whether one is one of these

  /// Of a word.
  bool allows(const std::string& word) const;
};

/// What the page says that the value of a key is: "a number above 0 [s]".
std::string described(const Key& key);

/// All keys of a language, tables before what they hold.
class Keys {
 public:
  explicit Keys(std::vector<Key> keys) : keys_(std::move(keys)) {}

  const std::vector<Key>& all() const { return keys_; }
  /// By its path as it stands in the list; null if it is not there.
  const Key* find(std::string_view path) const;
  /// The names of the keys of a table, "" for the file.
  std::vector<std::string> in(std::string_view table) const;
  /// By a path as a user writes it, "subsystems.motor.land", "connections.gain": NAME is any name there, and
  /// [] can be left out or have a number in it. Throws Error that tells which is near.
  const Key& named(const std::string& path) const;

  /// Tables in Markdown: one for each table of the language.
  std::string page() const;

 private:
  const Key* matching(const std::vector<std::string>& path) const;
  bool holds_tables_alone(const Key& table) const;

  std::vector<Key> keys_;
};

}  // namespace tandem::text
