// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "groups.hpp"
#include "table.hpp"
#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

struct Trace {
  std::size_t look;
  bool is_reference;
  std::vector<Point> points;
};

/// One panel: a quantity or several, or their differences from a reference. Those of one kind have one axis.
struct Strip {
  std::string title, label;
  std::size_t kind;
  std::vector<Trace> traces;
};

/// What a chart of traces shows, from above.
class Strips {
 public:
  Strips(const Chart& chart, const Charts& charts, const Table& table);

  const std::vector<Strip>& all() const { return strips_; }
  /// The names of traces, and of those that are references, by their looks.
  const std::vector<std::string>& names() const { return looks_.names(); }
  const std::vector<std::string>& references() const { return references_.names(); }
  /// Where the chart's `jumps` changes.
  const std::vector<double>& jumps() const { return jumps_; }

 private:
  std::string label_of(const std::vector<Quantity>& y) const;
  std::size_t look_of(std::size_t row, const std::vector<Quantity>& y, const Quantity& one);
  void add(const std::string& panel, const std::vector<std::size_t>& rows, std::size_t which);
  void add_traces(Strip& to, const std::vector<std::size_t>& rows, const Quantity& y,
                  const std::vector<Quantity>& all, const std::optional<Quantity>& less);
  void find_jumps(const std::vector<std::size_t>& rows);

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Groups looks_, references_;
  std::vector<Strip> strips_;
  std::vector<double> jumps_;
};

}  // namespace tandem::charts
