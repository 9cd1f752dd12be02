// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/coordinator/bounds.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// Rows of a History that have become visible.
struct NewRows {
  const double* first;
  std::int64_t count;
};

/// The recent samples of one subsystem. The subsystem appends into room(); readers see the rows after
/// commit(). Rows are numbered from 0 (the oldest seed, or else the first sample) and keep their number when
/// older ones are dropped.
class alignas(64) History {
 public:
  static constexpr std::int64_t min_capacity = 16;
  /// name: of the instance, for errors. capacity: rows that there is memory for at first (at least
  /// min_capacity). `info` must outlive the history.
  History(std::string name, const SubsystemInfo& info, std::int64_t capacity);
  History(History&&) = default;
  History& operator=(History&&) = default;

  /// See Bounds. Before the first commit().
  void watch(double until, double beyond) { bounds_.watch(until, beyond); }

  /// Where the subsystem appends. make_room() first.
  Samples& room() { return samples_; }
  /// Checks the appended rows, then makes them visible. Values are to be finite and within their bounds, jump
  /// flags 0 or 1. Times are to rise (a jump may repeat a time), and none may be past t_limit by more than
  /// the tolerance. t_limit: the one of the advance that gave the rows. Throws Error naming subsystem, call,
  /// port and time.
  NewRows commit(double t_limit, const TimeTolerance& tolerance) {
    const NewRows rows{row(committed_), base_ + samples_.size() - committed_};
    const double* y = rows.first;
    for (std::int64_t left = rows.count; left > 0; --left, ++committed_, y += stride())
      if (!plain(y, t_limit)) check(rows, t_limit, tolerance);
    return rows;
  }

  /// Takes the newest committed rows back, as if they had not been given. Precondition: some stay.
  void withdraw(std::int64_t rows) {
    committed_ -= rows;
    samples_ = Samples(data_.data(), stride(), capacity(), committed_ - base_);
  }

  std::int64_t oldest() const { return base_; }
  std::int64_t newest() const { return committed_ - 1; }  ///< last committed row
  bool empty() const { return committed_ == base_; }

  double time(std::int64_t row) const { return samples_.time(row - base_); }
  bool jump(std::int64_t row) const { return samples_.jump(row - base_); }
  std::span<const double> values(std::int64_t row) const { return samples_.values(row - base_); }
  /// The row as the subsystem wrote it: time, jump flag, values. The one before it stands stride() doubles
  /// earlier.
  const double* row(std::int64_t row) const { return samples_.rows() + (row - base_) * stride(); }
  std::int64_t stride() const { return samples_.stride(); }
  /// The values of the newest row, which is of a sampled subsystem, to be given anew, and checked then.
  double* newest_values() { return samples_.rows() + (newest() - base_) * stride() + Samples::header; }
  void check_newest() { bounds_.check(name_, time(newest()), values(newest())); }
  int outputs() const { return outputs_; }
  int derivatives() const { return derivatives_; }

  /// Number of the first row that the subsystem gave itself; rows before it are seeds.
  std::int64_t first_own() const { return seeds_; }
  /// Puts `count` past samples at t0 - k h before the only row, by Taylor expansion of the derivatives it
  /// carries. commit() makes them visible, and that row anew. Precondition: exactly one committed row, h > 0,
  /// count at most capacity() - 3.
  void seed(int count, double h);
  /// Puts whole rows, the oldest first, before the only row, as above.
  void seed(std::span<const double> past);
  /// Forgets everything.
  void clear();

  bool has_room(std::int64_t rows) const { return samples_.size() + rows <= capacity(); }
  /// Drops the committed rows before `keep`, and takes more memory where the others and `wanted` more would
  /// fill over half of it.
  void make_room(std::int64_t keep, std::int64_t wanted);
  std::int64_t capacity() const { return samples_.capacity(); }

  /// All rows, for a checkpoint, and back.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  /// Nothing is wrong with the row, which comes later than the one before it. (False for the first row and
  /// for a jump.)
  bool plain(const double* y, double t_limit) const {
    return bounds_.pass(y + Samples::header) && y[1] == 0.0 && y[0] <= t_limit && committed_ > base_ &&
           y[0] > y[-stride()];
  }
  void check(const NewRows& rows, double t_limit, const TimeTolerance& tolerance);
  [[noreturn]] void fail(const NewRows& rows, double t_limit, const std::string& what) const;
  bool are_rows(std::span<const double> rows) const;
  double taylor(const std::vector<double>& sample, int column, double s) const;

  // What a turn touches, in one line of the cache; Bounds begin with what they go by.
  Samples samples_;  ///< in data_
  std::int64_t base_ = 0, committed_ = 0;
  Bounds bounds_;

  std::int64_t seeds_ = 0;
  std::vector<double> data_;
  std::string name_;
  const SubsystemInfo* info_;
  int outputs_, derivatives_;
};

}  // namespace tandem
