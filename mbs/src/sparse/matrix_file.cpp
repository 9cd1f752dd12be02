// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/matrix_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "number_file.hpp"
#include "tandem/output_file.hpp"

namespace tandem::mbs {
namespace {

constexpr int most = std::numeric_limits<int>::max();

void write_text(const std::filesystem::path& file, const std::string& text) {
  OutputFile out(file, OutputFile::Begin::empty);
  out.write(text);
  out.close();
}

/// Whether the matrix is given by its lower triangle.
bool read_header(NumberFile& in) {
  const std::string found = in.first_line();
  std::istringstream words(found);
  std::string banner, object, format, field, symmetry;
  words >> banner >> object >> format >> field >> symmetry;
  for (std::string* word : {&object, &format, &field, &symmetry})
    std::transform(word->begin(), word->end(), word->begin(),
                   [](unsigned char c) { return std::tolower(c); });
  const bool known = banner == "%%MatrixMarket" && object == "matrix" && format == "coordinate" &&
                     (field == "real" || field == "integer") &&
                     (symmetry == "general" || symmetry == "symmetric");
  if (!known)
    in.refuse(
        "the first line is something else; allowed is '%%MatrixMarket matrix coordinate', then real or "
        "integer, "
        "then general or symmetric");
  return symmetry == "symmetric";
}

struct FileEntry {
  int row, column;
  double value;
};

Matrix sum_of(int rows, int columns, const std::vector<FileEntry>& entries) {
  std::vector<std::pair<int, int>> places;
  for (const FileEntry& e : entries) places.emplace_back(e.row, e.column);
  Matrix matrix{Pattern(rows, columns, std::move(places)), {}};
  matrix.values.assign(static_cast<std::size_t>(matrix.pattern.size()), 0.0);
  for (const FileEntry& e : entries) matrix.values[matrix.pattern.find(e.row, e.column)] += e.value;
  return matrix;
}

}  // namespace

void write_matrix_market(const std::filesystem::path& file, const Matrix& matrix) {
  const Pattern& p = matrix.pattern;
  std::string text = fmt::format("%%MatrixMarket matrix coordinate real general\n{} {} {}\n", p.rows(),
                                 p.columns(), p.size());
  const auto entries = p.entries();
  for (std::size_t k = 0; k < entries.size(); ++k)
    text += fmt::format("{} {} {}\n", entries[k].first + 1, entries[k].second + 1, matrix.values[k]);
  write_text(file, text);
}

Matrix read_matrix_market(const std::filesystem::path& file) {
  NumberFile in(file);
  const bool symmetric = read_header(in);
  const int rows = in.integer("the number of rows", 0, most),
            columns = in.integer("the number of columns", 0, most),
            count = in.integer("the number of entries", 0, most);
  if (symmetric && rows != columns) in.refuse("a symmetric matrix that is not square");
  std::vector<FileEntry> entries;
  for (int k = 0; k < count; ++k) {
    const int row = in.integer("a row", 1, rows) - 1, column = in.integer("a column", 1, columns) - 1;
    entries.push_back({row, column, in.number("a value")});
    if (symmetric && row != column) entries.push_back({column, row, entries.back().value});
  }
  in.end();
  return sum_of(rows, columns, entries);
}

void write_compressed_columns(const std::filesystem::path& file, const Matrix& matrix) {
  const Pattern& p = matrix.pattern;
  write_text(file, fmt::format(
                       "% compressed columns, counted from zero: rows columns entries; starts; rows; values\n"
                       "{} {} {}\n{}\n{}\n{}\n",
                       p.rows(), p.columns(), p.size(), fmt::join(p.starts(), " "),
                       fmt::join(p.indices(), " "), fmt::join(matrix.values, " ")));
}

Matrix read_compressed_columns(const std::filesystem::path& file) {
  NumberFile in(file);
  const int rows = in.integer("the number of rows", 0, most),
            columns = in.integer("the number of columns", 0, most - 1),
            count = in.integer("the number of entries", 0, most);
  std::vector<int> starts;
  for (int c = 0; c <= columns; ++c)
    starts.push_back(in.integer("a column's start", c == 0 ? 0 : starts.back(), c == 0 ? 0 : count));
  if (starts.back() != count)
    in.refuse(
        fmt::format("the last start is {}; allowed is the number of entries, {}", starts.back(), count));
  std::vector<std::pair<int, int>> entries;
  for (int c = 0; c < columns; ++c)
    for (int k = starts[c]; k < starts[c + 1]; ++k)
      entries.emplace_back(in.integer("a row", k == starts[c] ? 0 : entries.back().first + 1, rows - 1), c);
  Matrix matrix{Pattern(rows, columns, std::move(entries)), {}};
  for (int k = 0; k < count; ++k) matrix.values.push_back(in.number("a value"));
  in.end();
  return matrix;
}

}  // namespace tandem::mbs
