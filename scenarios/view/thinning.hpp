// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

namespace tandem::view {

/// Which rows of a table a page has: each by itself, or many in a row as a band of two, their smallest and
/// their largest value in the order in which they come. The first and the last row stand by themselves.
class Thinning {
 public:
  /// One of each `every` rows, and the last; 0: as many as a page can show of so many columns.
  Thinning(std::size_t rows, std::size_t columns, int every);

  std::size_t rows() const { return rows_; }          ///< in the page
  std::size_t most_in_band() const { return band_; }  ///< rows in a band; 1: there are none

  /// Bands of a quantity; NaN where all of its cells are empty.
  std::vector<double> bands(const std::vector<double>& values) const;
  /// The first and the last row of each band, as they are: for times, and for positions, which belong
  /// together.
  std::vector<double> ends(const std::vector<double>& values) const;

 private:
  struct Group {
    std::size_t begin, end;
  };
  void take(std::size_t rows, std::size_t step);
  void band(std::size_t rows, std::size_t most);

  std::vector<Group> groups_;
  std::size_t rows_ = 0, band_ = 1;
};

}  // namespace tandem::view
