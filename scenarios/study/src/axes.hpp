// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {

/// Columns that move together: values by column, all equally many.
struct Axis {
  std::vector<std::string> columns;
  std::vector<std::vector<FileValue>> values;
};

/// The lists and axes of a study.
class Axes {
 public:
  /// seed: of values that are drawn.
  Axes(text::Section& root, std::uint64_t seed);

  /// The rows of a block: its axes multiplied, the last one moving first, without those that `where` leaves
  /// out. The names of its columns are added to `columns`.
  std::vector<FileValues> rows(text::Section& block, std::vector<std::string>& columns) const;

 private:
  Axis axis(const text::Section& block, const toml::node& node) const;
  Axis table(const text::Document& document, const toml::table& table, const std::string& name) const;
  std::vector<FileValue> column(const text::Document& document, const toml::node& node,
                                const std::string& name) const;

  std::uint64_t seed_;
  std::map<std::string, Axis> lists_;
};

/// Whether a name can stand in expressions and headers: letters, digits and _, no digit first.
bool is_column_name(const std::string& name);
/// Throws Error(invalid_argument) for the name of one that each table has at its end: status, note.
void refuse_own_column(const std::string& what, const std::string& name, const text::Place& place);

}  // namespace tandem::study
