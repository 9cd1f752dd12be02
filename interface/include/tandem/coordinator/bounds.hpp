// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/error.hpp"
#include "tandem/subsystem_info.hpp"

namespace tandem {

/// Ends a run of which an output grows beyond all measure.
class Diverged final : public Error {
 public:
  explicit Diverged(const std::string& sentence) : Error(ErrorCode::numerical, sentence) {}
};

/// Up to which magnitude the values of a subsystem pass. Derivatives have only to be finite.
class Bounds {
 public:
  /// All finite ones pass, until watch(). `info` must outlive it.
  explicit Bounds(const SubsystemInfo& info);

  /// Outputs are learned up to t = `until` [s]. From then on each passes up to `beyond` times the largest of
  /// its magnitude by then, its port's nominal value and 1. `beyond` is above 1; infinite: nothing changes.
  void watch(double until, double beyond);

  /// Whether a row of these values passes by the least of all bounds, or, while outputs are learned, of all
  /// that was seen; if not, check() tells. False for what is not a number.
  bool pass(const double* values) const {
    bool within = true;
    std::int32_t k = 0;
    for (; k < outputs_; ++k) within &= std::abs(values[k]) <= least_;
    for (; k < columns_; ++k) within &= std::abs(values[k]) <= std::numeric_limits<double>::max();
    return within;
  }
  /// Learns of a row at t, of finite values, or throws Diverged for one that does not pass, naming
  /// `subsystem`, output, time, value and bound.
  void check(const std::string& subsystem, double t, std::span<const double> values);

  /// For a checkpoint, and back, into those that watch alike.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  void settle();
  void find_least();

  std::int32_t outputs_, columns_;  ///< columns: with derivatives
  double least_ = 0.0;              ///< of most_
  const SubsystemInfo* info_;
  bool learning_ = false;
  double until_ = 0.0, beyond_ = 0.0;
  std::vector<double> most_;  ///< by output; while it learns, what was seen
};

}  // namespace tandem
