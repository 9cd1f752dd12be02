// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <utility>
#include <vector>

namespace tandem::mbs {

/// Which entries of a sparse matrix are stored: compressed columns, rows ascending within each. The values
/// stand elsewhere, in a vector of size() doubles in the same order.
class Pattern {
 public:
  Pattern() = default;
  /// entries: (row, column) in any order; one that is there twice is stored once.
  Pattern(int rows, int columns, std::vector<std::pair<int, int>> entries);

  int rows() const { return rows_; }
  int columns() const { return static_cast<int>(starts_.size()) - 1; }
  int size() const { return starts_.back(); }
  /// Of each column its first position, and size() at the end.
  std::span<const int> starts() const { return starts_; }
  /// Of each position its row.
  std::span<const int> indices() const { return indices_; }
  /// Columns next to each other that are alike, in order: what loops over columns go by, so that they ask for
  /// the numbers once a run.
  struct Run {
    int first, columns;
    int start;     ///< Position of the first entry.
    int groups;    ///< Of entries, in each column.
    int together;  ///< Rows of a group: 2 or 3 if entries come in pairs or triples of rows without a gap.
    int abreast;  ///< 2 or 3 if entries stand alone: of so many columns each has the last one's rows, plus 1.
    bool operator==(const Run&) const = default;
  };
  std::span<const Run> runs() const { return runs_; }
  /// Position of an entry; -1 if it is not stored.
  int find(int row, int column) const;

  /// (row, column) by position.
  std::vector<std::pair<int, int>> entries() const;
  /// The entries on and below the diagonal.
  Pattern lower() const;
  bool operator==(const Pattern&) const = default;

 private:
  void add_runs();
  int rows_ = 0;
  std::vector<int> starts_ = {0}, indices_;
  std::vector<Run> runs_;
};

/// Lengthens the last run, or begins the next if it is not alike.
void append(std::vector<Pattern::Run>& runs, const Pattern::Run& next);

/// 2 or 3 if so many things come out even in pairs or triples, else 1.
inline int in_step(int count) { return count % 2 == 0 ? 2 : count % 3 == 0 ? 3 : 1; }

/// The entries of both. Precondition: the same shape.
Pattern unite(const Pattern& a, const Pattern& b);

/// By position of `part` the position in `whole`; -1 for an entry that it has not.
std::vector<int> positions(const Pattern& part, const Pattern& whole);

/// A sparse matrix whose pattern stays.
struct Matrix {
  Pattern pattern;
  std::vector<double> values;
};

}  // namespace tandem::mbs
