// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/coordinator/history.hpp"

namespace tandem {

/// The newest rows of those outputs of a subsystem that somebody looks at between its rows, too.
class OutputTrack {
 public:
  explicit OutputTrack(const SubsystemInfo& info) : info_(&info) {}

  /// The column of an output; the same one for the same output. Before the first add().
  std::size_t column(int output);
  /// Rates are wanted, too.
  void want_rates() { wants_rates_ = true; }

  void add(const History& history, std::int64_t first, std::int64_t last);
  /// Forgets the rows before `row`, now and then.
  void drop_before(std::int64_t row);

  std::int64_t newest() const { return first_ + count_ - 1; }
  /// Minus infinity where there are no rows.
  double newest_time() const {
    return count_ == 0 ? -std::numeric_limits<double>::infinity() : at(newest())[0];
  }
  bool has(std::int64_t row) const { return row >= first_ && row <= newest(); }
  double time(std::int64_t row) const { return at(row)[0]; }
  /// The row has none before it that it goes on from.
  bool begins(std::int64_t row) const { return at(row)[1] == 1.0; }

  /// Looks at a time between the row before `row`, which does not begin anew, and that.
  void look(std::int64_t row, double t);
  // There, by column; rates where they are wanted.
  double value(std::size_t column) const { return values_[column]; }
  double rate(std::size_t column) const { return rates_[column]; }

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  static constexpr int most_nodes = 4;
  static constexpr std::ptrdiff_t header = 2;
  /// Of a row: its time, the number of rows since the last jump up to most_nodes, and of each column value and
  /// derivative.
  std::ptrdiff_t stride() const { return header + 2 * static_cast<std::ptrdiff_t>(outputs_.size()); }
  const double* at(std::int64_t row) const { return rows_.data() + (row - first_) * stride(); }
  void look_between(const double* row, double x);
  void look_by_nodes(const double* row, int nodes, double t);
  void weigh(const double* row, int nodes, double t, double* values, double* rates) const;
  bool weigh_equal(const double* row, double t, double* values) const;

  const SubsystemInfo* info_;
  std::vector<int> outputs_;      ///< by column
  std::vector<char> has_slopes_;  ///< likewise
  bool any_slopes_ = false, all_slopes_ = true, wants_rates_ = false;
  std::int64_t first_ = 0, count_ = 0;  ///< the row that is kept first, and how many there are
  std::vector<double> rows_;
  std::vector<double> values_, rates_;
};

}  // namespace tandem
