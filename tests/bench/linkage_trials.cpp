// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_trials.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "tandem/charts/pareto.hpp"

namespace tandem::bench {
namespace {

constexpr double asked = 1e-3;  // [m]

/// On one method's front, by rising time.
std::optional<Cost> cost_on(const std::vector<charts::Point>& front, double error,
                            const std::string& method) {
  if (front.empty() || front.back().y > error) return std::nullopt;
  if (front.front().y <= error) return Cost{front.front().x, front.front().y < error, method};
  std::size_t k = 1;
  while (front[k].y > error) ++k;
  const charts::Point &a = front[k - 1], &b = front[k];
  const double part = std::log(error / a.y) / std::log(b.y / a.y);
  return Cost{a.x * std::pow(b.x / a.x, part), false, method};
}

std::string seconds(const std::optional<Cost>& cost) {
  return cost ? fmt::format("{}{:.2g} s", cost->bound ? "<" : "", cost->seconds) : "-";
}

std::string ratio(const std::optional<Cost>& above, const std::optional<Cost>& below) {
  if (!above || !below || (above->bound && below->bound)) return "-";  // of two bounds there is none
  return fmt::format("{}{}{:.0f}", above->bound ? "<" : "", below->bound ? ">" : "",
                     above->seconds / below->seconds);
}

template <class Holds>
std::optional<Cost> cost_where(const std::vector<LinkageTrial>& runs, const Holds& holds) {
  std::vector<LinkageTrial> some;
  for (const LinkageTrial& r : runs)
    if (holds(r)) some.push_back(r);
  return cost_of(some, asked);
}

std::vector<std::string> row(const std::vector<LinkageTrial>& runs) {
  const auto simbody = cost_where(runs, [](const auto& r) { return r.code == "simbody"; });
  const auto tandem = cost_where(runs, [](const auto& r) { return r.code == "tandem"; });
  const auto index3 = cost_where(runs, [](const auto& r) { return r.family() == "index3"; });
  return {runs.front().start,
          std::to_string(runs.front().loops),
          seconds(simbody),
          simbody ? simbody->method : "",
          seconds(index3),
          ratio(simbody, index3),
          seconds(tandem),
          ratio(simbody, tandem),
          tandem ? tandem->method : ""};
}

}  // namespace

std::optional<Cost> cost_of(const std::vector<LinkageTrial>& runs, double error) {
  std::map<std::string, std::vector<charts::Point>> methods;
  for (const LinkageTrial& r : runs)
    if (r.ok()) methods[r.method].push_back({r.seconds, r.error});
  std::optional<Cost> least;
  for (auto& [method, points] : methods) {
    const auto cost = cost_on(charts::pareto_front(std::move(points)), error, method);
    if (cost && (!least || cost->seconds < least->seconds)) least = cost;
  }
  return least;
}

Table ratios(const std::vector<LinkageTrial>& runs) {
  Table table({"start", "loops", "simbody", "simbody_by", "index3", "index3_times", "tandem", "tandem_times",
               "tandem_by"},
              "at_1_mm");
  std::vector<LinkageTrial> same;
  for (const LinkageTrial& r : runs) {
    if (!same.empty() && (r.start != same.front().start || r.loops != same.front().loops)) {
      table.add(row(same));
      same.clear();
    }
    same.push_back(r);
  }
  if (!same.empty()) table.add(row(same));
  return table;
}

}  // namespace tandem::bench
