// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/coordinator/link.hpp"

namespace tandem {

/// For each new row of the source: weights = make.prepare(row, fitted), where `fitted` rows before it may be
/// fitted together with it, and for each lane make.fill(weights, row, lane, table, coefficients), where
/// `table` is the lane's memory.
template <class Make>
void Link::extend_rows(const History& source, const Make& make) {
  for (; end_ <= source.newest(); ++end_) {
    const double* row = source.row(end_);
    if (row[1] != 0.0) fit_from_ = end_;
    const double origin = row[0] + delay_, end = origin + tolerance_.width(origin, origin);
    const auto weights = make.prepare(row, end_ - fit_from_);
    Segment* s = segments_.data() + (end_ - base_);
    double* table = differences_.data();
    for (const Lane& lane : lanes_) {
      s->end = end;
      s->origin = origin;
      make.fill(weights, row, lane, table, s->c);
      s += capacity_;
      table += TANDEM_MAX_COEFFICIENTS;
    }
  }
}

}  // namespace tandem
