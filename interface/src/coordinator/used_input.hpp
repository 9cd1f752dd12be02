// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/signal.hpp"

namespace tandem {

/// One input as its reader used it, from call to call.
class UsedInput {
 public:
  /// In a call over this span, which begins where the one before ended.
  void add(const Signal& signal, TimeSpan span);
  /// At an instant, of a sampled reader.
  void add(double t, double value);
  /// The reader stands at t again.
  void go_back(double t);
  /// At t, which is not before that of the call before; NaN where nothing is known.
  double value(double t) {
    while (first_ + 1 < pieces_.size() && pieces_[first_].until < t) ++first_;
    if (first_ == pieces_.size() || t < from_ || t > pieces_[first_].until)
      return std::numeric_limits<double>::quiet_NaN();
    const double *c = pieces_[first_].segment.c, x = t - pieces_[first_].segment.origin;
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
  }

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  struct Piece {
    double until;
    Segment segment;
  };
  void push(const Piece& piece);

  std::vector<Piece> pieces_;
  std::size_t first_ = 0;  ///< those before it are no longer needed
  double from_ = std::numeric_limits<double>::infinity();
};

}  // namespace tandem
