// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <toml++/toml.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scenario/place.hpp"

namespace tandem::scenario {

/// A TOML file with the overrides of the command line put into it. Every value knows where it came from.
class Document {
 public:
  /// Throws Error for a file that can't be read, with file and line for one that is not TOML, and for an
  /// override that names what is not there (see set.hpp).
  Document(const std::filesystem::path& file, const std::vector<std::string>& overrides);

  const std::string& file() const { return file_; }
  const toml::table& table() const { return table_; }
  Place place(const toml::node& node) const;

 private:
  std::string file_;
  toml::table table_;
};

/// Keys and values of a table in the order of the file; those of overrides last.
std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table);

std::vector<std::string> keys(const toml::table& table);

/// "the number 3", "the text 'abc'", "a table": what an error says it found.
std::string described(const toml::node& node);

/// The same values, in the order of the file.
nlohmann::ordered_json to_json(const toml::node& node);

}  // namespace tandem::scenario
