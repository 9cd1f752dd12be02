// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "refuse.hpp"
#include "sort.hpp"

namespace tandem::engine {
namespace {

/// A signal as a function of one other: constant, a curve, or data over time.
struct Known {
  std::function<double(double)> at = {};  ///< empty: it is not known
  int of = -1;                            ///< the other signal; -1 of a constant
  std::vector<double> points = {};        ///< where it may be highest or lowest

  bool varies() const { return !points.empty(); }
};

/// At each jump both sides.
std::vector<double> points_of(const TimeSeries& data) {
  std::vector<double> all;
  for (const Segment& s : data.pieces()) all.push_back(s.origin);
  for (const double t : data.jumps())
    all.push_back(std::nextafter(t, -std::numeric_limits<double>::infinity()));
  all.push_back(data.pieces().back().end);
  std::erase_if(all, [](double t) { return !std::isfinite(t); });
  return all;
}

Known known(const Lowering& d, const std::vector<int>& maker, int signal) {
  signal = d.resolved(signal);
  if (const Slot& slot = d.signals[signal]; slot.kind == Slot::Kind::constant)
    return {[value = slot.start](double) { return value; }};
  if (maker[signal] < 0) return {};
  const Operation& o = d.steps[maker[signal]].operations.front();
  const int of = d.resolved(o.a);
  if (o.code == Operation::Code::curve) return {std::cref(d.curves[o.b]), of, d.curves[o.b].x()};
  if (o.code != Operation::Code::data) return {};
  return {[&data = d.series[o.b]](double t) { return data.value(t); }, of, points_of(d.series[o.b])};
}

void check(const Lowering::Order& order, const Known& above, const Known& below, double x) {
  if (above.at(x) > below.at(x)) return;
  const bool varies = above.varies() || below.varies();
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
    if (!above.at || !below.at || !comparable) continue;
    if (!above.varies() && !below.varies()) check(order, above, below, 0.0);
    for (const Known* side : {&above, &below})
      for (const double x : side->points) check(order, above, below, x);
  }
}

}  // namespace tandem::engine
