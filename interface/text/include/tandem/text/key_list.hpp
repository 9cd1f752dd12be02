// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tandem/text/keys.hpp"

namespace tandem::text {

/// What not every key has.
struct KeyDetails {
  std::string unit = {}, otherwise = {}, allowed = {};
  std::vector<std::string> words = {};
  std::string pattern = {};
  bool (*also)(const std::string&) = nullptr;
};

/// Writes the keys of a language down, table by table: each key belongs to the table that was begun last, and
/// before the first to the file.
class KeyList {
 public:
  /// Begins a table, "coordination", or an array of tables, "connections[]".
  KeyList& table(std::string path, std::string sentence, bool required = false);
  /// In place of the table that was begun last there may be a number, or an array of numbers.
  KeyList& or_numbers();
  /// Begins [NAME.*]: tables of any name below `path`, which holds nothing else.
  KeyList& named(const std::string& path, std::string sentence, std::string of_each, bool required = false);
  /// The tables begun last, an array of them, say by a key `kind` what each is.
  KeyList& by_kind();
  /// Begins the keys that the tables named last, or those by kind, have where their key `kind` is this word.
  KeyList& kind(std::string word, std::string sentence);
  /// A key that may be there, and one that has to be.
  KeyList& may(const std::string& name, Key::Type type, std::string sentence, KeyDetails details = {});
  KeyList& need(const std::string& name, Key::Type type, std::string sentence, KeyDetails details = {});

  std::vector<Key> list() && { return std::move(keys_); }

 private:
  std::vector<Key> keys_;
  std::string table_, with_kinds_;  ///< that are written now, and of any name that were last
  std::vector<std::string> kinds_;
};

}  // namespace tandem::text
