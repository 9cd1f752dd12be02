// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/pareto.hpp"

#include <algorithm>
#include <utility>

namespace tandem::charts {

std::vector<Point> pareto_front(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::vector<Point> front;
  for (const Point& p : points)
    if (front.empty() || p.y < front.back().y) front.push_back(p);
  return front;
}

}  // namespace tandem::charts
