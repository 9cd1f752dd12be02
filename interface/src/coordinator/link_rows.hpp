// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/coordinator/link.hpp"

namespace tandem {

/// For each new row of the source: weights = make.prepare(row, fitted), where `fitted` rows before it may be
/// fitted together with it, and for each lane make.fill(weights, row, lane, table, coefficients), where
/// `table` is the lane's memory.
template <class Make>
void Link::extend_rows(NewRows rows, const Make& make) {
  if (nearest_ > 0.0) return extend_spread(rows, make);
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

/// The same on the rows that are not passed over, from the oldest of them on each time; near a jump they are
/// others in each lane.
template <class Make>
void Link::extend_spread(NewRows rows, const Make& make) {
  const double* row = rows.first;
  const std::span<const Lane> lanes = lanes_;
  for (std::int64_t left = rows.count; left > 0; --left, ++fitted_, ++count_, row += stride_)
    if (!jump_near(row))
      fit(row, gather_nodes(row, nullptr), lanes, make);
    else
      for (std::size_t l = 0; l < lanes.size(); ++l)
        fit(row, gather_nodes(row, &lanes[l]), lanes.subspan(l, 1), make);
}

/// The segments of some lanes behind the last ones, from the gathered nodes.
template <class Make>
void Link::fit(const double* row, int nodes, std::span<const Lane> lanes, const Make& make) {
  const double* node = nodes_.data() + (how_.samples() - nodes) * stride_;
  const auto before = lanes.data() - lanes_.data();
  for (int k = 0; k < nodes; ++k, node += stride_) {
    const auto weights = make.prepare(node, k);
    double* table = differences_.data() + before * TANDEM_MAX_COEFFICIENTS;
    Segment* s = first_ + count_ + before * capacity_;
    for (const Lane& lane : lanes) {
      s->origin = row[0] + delay_;
      s->end = s->origin + tolerance_.width(s->origin, s->origin);
      make.fill(weights, node, lane, table, s->c);
      mark_jump(*s, jumps(row, lane));
      s += capacity_;
      table += TANDEM_MAX_COEFFICIENTS;
    }
  }
}

}  // namespace tandem
