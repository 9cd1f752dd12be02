// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tandem/text/place.hpp"
#include "tandem/text/set_value.hpp"

namespace tandem::text {

/// A TOML text. Every value knows where it came from: a line, or an override that was put in.
class Document {
 public:
  /// Throws Error for a file that can't be read, and with file, line and column, and none of its text, for
  /// one that is not TOML.
  explicit Document(const std::filesystem::path& file);
  /// Of a text; `name` is what errors call it. lines: what errors call its lines, if that is not their number.
  Document(std::string name, const std::string& text, std::vector<int> lines = {});

  /// Puts overrides of the command line in, "KEY=VALUE" (set.hpp). Throws Error that names the one that can't
  /// be.
  void set(const std::vector<std::string>& overrides);
  /// One of them, with a value of its own.
  void set(const std::string& path, const SetValue& value);

  const std::string& file() const { return file_; }
  const toml::table& table() const { return table_; }
  Place place(const toml::node& node) const;

 private:
  int line(const toml::source_position& at) const;

  std::string file_;
  std::vector<int> lines_;
  toml::table table_;
};

/// Keys and values of a table in the order of the file; those of overrides last.
std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table);

std::vector<std::string> keys(const toml::table& table);

/// "the number 3", "the text 'abc'", "a table": what an error says it found.
std::string described(const toml::node& node);

}  // namespace tandem::text
