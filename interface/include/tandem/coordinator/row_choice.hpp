// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <limits>

#include "tandem/bytes.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// Which rows of a run are recorded.
struct RowRules {
  double from = -std::numeric_limits<double>::infinity();  ///< [s], with rounding, as is `to`
  double to = std::numeric_limits<double>::infinity();
  /// [s]: the first row at or after each multiple of it from `from` on, or from the start; all that have the
  /// time of one that is recorded (a jump's two), and the last. 0: all.
  double every = 0.0;
};

/// The rules, row by row of one file.
class RowChoice {
 public:
  RowChoice() = default;
  RowChoice(const RowRules& rules, double t_start);

  /// Whether the row at t, at or after the ones before, is recorded; last: there is none after it.
  bool takes(double t, bool last);
  /// The last row is another one as long as others come: it is known when the run is at its end.
  bool waits() const { return rules_.every > 0.0; }

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  RowRules rules_;
  TimeTolerance tolerance_;
  double begin_ = 0.0;                                        ///< of the multiples
  std::int64_t next_ = 0;                                     ///< the multiple that is waited for
  double newest_ = -std::numeric_limits<double>::infinity();  ///< that was taken
};

}  // namespace tandem
