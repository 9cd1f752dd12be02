// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"

#include <fmt/format.h>

#include "refuse.hpp"
#include "sort.hpp"

namespace tandem::engine {
namespace {

/// A signal as a function of one other: constant, or a curve.
struct Known {
  int of = -1;  ///< the other signal; -1 of a constant
  const Curve* curve = nullptr;
  double value = 0.0;
  bool is_known = false;

  double at(double x) const { return curve ? (*curve)(x) : value; }
};

Known known(const Lowering& d, const std::vector<int>& maker, int signal) {
  signal = d.resolved(signal);
  if (d.signals[signal].kind == Slot::Kind::constant) return {-1, nullptr, d.signals[signal].start, true};
  if (maker[signal] < 0) return {};
  const Operation& o = d.steps[maker[signal]].operations.front();
  if (o.code != Operation::Code::curve) return {};
  return {d.resolved(o.a), &d.curves[o.b], 0.0, true};
}

void check(const Lowering::Order& order, const Known& above, const Known& below, double x) {
  if (above.at(x) > below.at(x)) return;
  const bool varies = above.curve || below.curve;
  refuse(order.where,
         fmt::format("{}: {} is {}{}; allowed is above {}, {}", order.owner, order.high, above.at(x),
                     varies ? fmt::format(" at {} of their tables", x) : "", below.at(x), order.low));
}

}  // namespace

void refuse_disorder(const Lowering& d) {
  if (d.orders.empty()) return;
  const auto maker = makers(d);
  for (const auto& order : d.orders) {
    const Known above = known(d, maker, order.above), below = known(d, maker, order.below);
    const bool comparable = above.of == below.of || above.of < 0 || below.of < 0;
    if (!above.is_known || !below.is_known || !comparable) continue;
    if (!above.curve && !below.curve) check(order, above, below, 0.0);
    for (const Known* side : {&above, &below})
      if (side->curve)
        for (const double x : side->curve->x()) check(order, above, below, x);
  }
}

}  // namespace tandem::engine
