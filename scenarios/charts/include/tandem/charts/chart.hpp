// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tandem/text/key_list.hpp"
#include "tandem/text/section.hpp"

namespace tandem::charts {

/// A number of each row of a table: the name of a column, or an expression of columns.
struct Quantity {
  std::string text;
  text::Place place;
};

/// A line at one value of an axis, over all panels.
struct Line {
  std::optional<double> x, y;
  std::string name;
};

/// Cells of a map for which an expression holds.
struct Sign {
  Quantity when;
  std::string name;
};

/// Points of a second table that lie over those of the first.
struct Overlay {
  std::string table, name;
  std::optional<Quantity> where;
};

/// A chart as a file describes it (docs/studies.md).
struct Chart {
  enum class Kind { curves, work, map, traces, table };
  std::string name;  ///< the stem of its files
  Kind kind;
  std::string table;  ///< TABLE.csv in the folder of results; empty: the only one
  std::string title;
  std::vector<std::string> notes;            ///< lines below it
  std::map<std::string, std::string> names;  ///< in place of those of the file
  std::optional<Quantity> where;             ///< the rows that it draws
  std::vector<std::string> panels;
  int across = 0;  ///< panels side by side; 0: as many as there are, up to four

  // curves and work: a row of panels for each pair of these
  std::vector<Quantity> x;
  std::vector<std::vector<Quantity>> y;
  std::vector<std::string> colour, marker;
  bool log_x = false, log_y = false, percent = false, joined = false, front = false;
  std::optional<double> limit, tolerance;
  std::optional<Quantity> hollow, floor;
  std::vector<double> slopes;
  std::vector<Line> lines;
  std::optional<Overlay> overlay;

  // map and table
  std::vector<std::string> rows;
  std::string columns;

  // map
  std::optional<Quantity> value;
  std::vector<double> limits;
  std::vector<Sign> signs;
  std::string text;            ///< the column of which the first letter stands in each cell
  std::optional<double> best;  ///< of each column, if its value is not above this
  std::optional<Sign> also;    ///< the best of these cells is marked too

  // traces: y against x, a panel for each y
  std::vector<std::vector<double>> windows;
  std::vector<std::string> series;
  std::string difference, jumps;

  // table: y are its cells
  std::vector<std::string> each;  ///< what several rows in a cell make; empty: there is one
  int digits = 2;                 ///< that count, of numbers that are not whole

  text::Place place;
};

/// The columns of its table that a chart needs, each with the place that names it.
std::vector<Quantity> columns_of(const Chart& chart);

/// The charts of a file, and words for what stands in tables.
struct Charts {
  std::vector<Chart> all;
  std::map<std::string, std::string> names;
  std::filesystem::path beside = {};  ///< the file's folder: a table that is not in the results may lie there

  /// What a column, a word or a number is called.
  const std::string& name_of(const std::string& word) const;
};

/// Adds the keys `charts[]` and `names` to a language.
void add_keys(text::KeyList& to);
/// The language of a file that holds charts alone.
const text::Keys& keys();

/// Reads `charts` and `names`. Throws Error with file, line, the value found and what is allowed.
Charts read_charts(text::Section& root);

}  // namespace tandem::charts
