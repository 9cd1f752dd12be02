// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/coordinator/link.hpp"

namespace tandem {

/// For each new row of the source: weights = make.prepare(row, fitted), where `fitted` rows before it may be
/// fitted together with it, and for each lane make.fill(weights, row, lane, table, coefficients), where
/// `table` is the lane's memory. join: makes what joins two samples of which the older is passed over.
template <class Make, class Join>
void Link::extend_rows(NewRows rows, const Make& make, const Join& join) {
  if (nearest_ > 0.0) return extend_spread(rows, make, join);
  const double* row = rows.first;
  for (std::int64_t left = rows.count; left > 0; --left, row += stride_) {
    if (row[1] != 0.0) fitted_ = 0;
    const auto weights = make.prepare(row, fitted_++);
    const double origin = row[0] + delay_, end = origin + tolerance_.width(origin, origin);
    Segment* s = first_ + count_++;
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

/// The same on the rows that are not passed over.
template <class Make, class Join>
void Link::extend_spread(NewRows rows, const Make& make, const Join& join) {
  const double* row = rows.first;
  for (std::int64_t left = rows.count; left > 0; --left, ++fitted_, ++count_, row += stride_) {
    goes_on_ = joins_step_to(row);
    if (!goes_on_) {
      fit_lanes(row, first_ + count_, false, make);
      continue;
    }
    fit_lanes(row, first_ + count_, true, join);
    if (left == 1) fit_lanes(row, first_ + count_ + 1, false, make), go_on_behind(count_);
  }
}

/// The segments of a row, from the oldest node on each time; near a jump they are others in each lane.
template <class Make>
void Link::fit_lanes(const double* row, Segment* to, bool joined, const Make& make) {
  const std::span<const Lane> lanes = lanes_;
  if (!jump_near(row)) return gather_nodes(row, nullptr, joined), fit(row, to, lanes, make);
  for (std::size_t l = 0; l < lanes.size(); ++l) {
    gather_nodes(row, &lanes[l], joined);
    fit(row, to, lanes.subspan(l, 1), make);
  }
}

/// Those of some lanes, from the gathered nodes; `to` is of lane 0.
template <class Make>
void Link::fit(const double* row, Segment* to, std::span<const Lane> lanes, const Make& make) {
  const double* node = nodes_.data() + static_cast<std::int64_t>(nodes_.size()) - gathered_ * stride_;
  const auto before = lanes.data() - lanes_.data();
  for (int k = 0; k < gathered_; ++k, node += stride_) {
    const auto weights = make.prepare(node, k);
    double* table = differences_.data() + before * TANDEM_MAX_COEFFICIENTS;
    Segment* s = to + before * capacity_;
    for (const Lane& lane : lanes) {
      const double origin = row[0] + delay_;
      *s = Segment{origin + tolerance_.width(origin, origin), origin, {}};
      make.fill(weights, node, lane, table, s->c);
      mark_jump(*s, jumps(row, lane));
      s += capacity_;
      table += TANDEM_MAX_COEFFICIENTS;
    }
  }
}

}  // namespace tandem
