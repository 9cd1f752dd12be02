// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include "tandem/subsystem.h"

namespace tandem {

/// Rows of output samples in the caller's memory. A row is: time [s], jump flag, the outputs, their first
/// time derivatives, their second ones, and so on (SubsystemInfo::derivatives() blocks; 0 where a port gives
/// fewer). A subsystem appends one row after each own step and never rewrites one.
class Samples {
 public:
  static constexpr std::int64_t header = 2;  ///< columns before the first output: time and jump flag

  Samples() = default;
  /// Room for `capacity` rows of `stride` doubles at `rows`, the first `size` of them already filled.
  Samples(double* rows, std::int64_t stride, std::int64_t capacity, std::int64_t size = 0)
      : data_{rows, stride, capacity, size} {}

  std::int64_t size() const { return data_.size; }
  bool full() const { return data_.size == data_.capacity; }
  std::int64_t room() const { return data_.capacity - data_.size; }  ///< rows that can be appended

  /// A new row at time t; returns what follows the header, to be filled by the caller: outputs, then
  /// derivatives. jump: no reconstruction fits a polynomial across the gap before this row. Precondition: not
  /// full().
  double* append(double t, bool jump = false) {
    assert(!full());
    double* row = data_.rows + data_.stride * data_.size++;
    row[0] = t;
    row[1] = jump ? 1.0 : 0.0;
    return row + header;
  }

  double time(std::int64_t row) const { return at(row)[0]; }
  bool jump(std::int64_t row) const { return at(row)[1] != 0.0; }
  /// Outputs, then derivatives, of a row.
  std::span<const double> values(std::int64_t row) const {
    return {at(row) + header, static_cast<std::size_t>(data_.stride - header)};
  }

  double* rows() const { return data_.rows; }
  std::int64_t stride() const { return data_.stride; }
  std::int64_t capacity() const { return data_.capacity; }

  /// The same rows as the C interface has them.
  tandem_samples c_view() const { return data_; }
  /// These themselves, for a call across it to fill. Whoever makes the call sees to it that in the end
  /// nothing has changed but the size.
  tandem_samples& c_rows() { return data_; }
  /// Precondition: at least the present size, at most the capacity.
  void set_size(std::int64_t size) {
    assert(size >= data_.size && size <= data_.capacity);
    data_.size = size;
  }

 private:
  const double* at(std::int64_t row) const {
    assert(row >= 0 && row < data_.size);
    return data_.rows + data_.stride * row;
  }
  tandem_samples data_{nullptr, header, 0, 0};
};

}  // namespace tandem
