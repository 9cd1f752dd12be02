// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <vector>

#include "axis.hpp"
#include "groups.hpp"
#include "looks.hpp"
#include "table.hpp"

namespace tandem::charts {

/// A row of a table in a panel.
struct Mark {
  std::size_t panel = 0;
  Look look = {};
  std::optional<double> x, y;  ///< y: nothing where it is no result
  bool hollow = false;
};

/// The points of curves and work charts: which panel each is in, and how it looks.
class Points {
 public:
  Points(const Chart& chart, const Charts& charts, const Table& table);

  const std::vector<std::string>& panels() const { return panels_.names(); }
  const Groups& colours() const { return colours_; }
  const Groups& markers() const { return markers_; }
  /// The words of x, where it has no numbers.
  const std::vector<std::string>& words() const { return words_.names(); }

  /// Those of a row of panels.
  std::vector<Mark> marks(std::size_t row) const;
  /// Of the overlay; their looks are its own.
  std::vector<Mark> overlaid(std::size_t row, const Table& other) const;
  /// The error of the reference in each panel, where the table tells it.
  std::vector<std::optional<double>> floors(std::size_t row) const;

 private:
  std::size_t colour_of(std::size_t row, const std::vector<Quantity>& y, const Quantity& one) const;
  std::optional<double> x_of(const Table& table, std::size_t row, const Quantity& x) const;

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  std::vector<std::size_t> rows_;
  mutable Groups panels_, colours_, markers_, words_;
};

}  // namespace tandem::charts
