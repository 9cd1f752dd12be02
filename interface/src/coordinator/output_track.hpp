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
  void look(std::int64_t row, double t) {
    if (row != fitted_) fit(row);
    const double x = t - origin_;
    const double* c = cubics_.data();
    for (std::size_t k = 0; k < values_.size(); ++k, c += most_nodes) {
      values_[k] = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
      rates_[k] = c[1] + x * (2.0 * c[2] + x * 3.0 * c[3]);
    }
  }
  // There, by column.
  double value(std::size_t column) const { return values_[column]; }
  double rate(std::size_t column) const { return rates_[column]; }

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  static constexpr int most_nodes = 4;
  static constexpr std::ptrdiff_t header = 2;
  const double* at(std::int64_t row) const { return rows_.data() + (row - first_) * stride_; }
  void fit(std::int64_t row);
  void fit_slopes(const double* row);
  void fit_nodes(const double* row, int nodes);

  const SubsystemInfo* info_;
  /// Of a row: its time, the number of rows since the last jump up to most_nodes, and of each column value and
  /// derivative.
  std::ptrdiff_t stride_ = header;
  std::vector<int> outputs_;      ///< by column
  std::vector<char> has_slopes_;  ///< likewise
  bool any_slopes_ = false, all_slopes_ = true;
  std::int64_t first_ = 0, count_ = 0;  ///< the row that is kept first, and how many there are
  std::vector<double> rows_;
  std::int64_t fitted_ = -1;    ///< the row that ends the step of the cubics
  double origin_ = 0.0;         ///< of the cubics, the begin of that step [s]
  std::vector<double> cubics_;  ///< by column, four coefficients each
  std::vector<double> values_, rates_;
};

}  // namespace tandem
