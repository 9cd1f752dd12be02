// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/linkage_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "tandem/charts/csv_table.hpp"
#include "tandem/charts/pareto.hpp"
#include "tandem/error.hpp"

namespace tandem::charts {
namespace {

constexpr double asked = 1e-3;  // [m]

/// On one method's front, by rising time.
std::optional<Cost> cost_on(const std::vector<Point>& front, double error, const std::string& method) {
  if (front.empty() || front.back().y > error) return std::nullopt;
  if (front.front().y <= error) return Cost{front.front().x, front.front().y < error, method};
  std::size_t k = 1;
  while (front[k].y > error) ++k;
  const Point &a = front[k - 1], &b = front[k];
  const double part = std::log(error / a.y) / std::log(b.y / a.y);
  return Cost{a.x * std::pow(b.x / a.x, part), false, method};
}

std::string seconds(const std::optional<Cost>& cost) {
  return cost ? fmt::format("{}{:.2g} s", cost->bound ? "<" : "", cost->seconds) : "-";
}

std::string ratio(const std::optional<Cost>& above, const std::optional<Cost>& below) {
  if (!above || !below) return "-";
  return fmt::format("{}{}{:.0f}", above->bound ? "<" : "", below->bound ? ">" : "",
                     above->seconds / below->seconds);
}

template <class Holds>
std::optional<Cost> cost_where(const std::vector<LinkageRun>& runs, const Holds& holds) {
  std::vector<LinkageRun> some;
  for (const LinkageRun& r : runs)
    if (holds(r)) some.push_back(r);
  return cost_of(some, asked);
}

std::string line(const std::vector<LinkageRun>& runs) {
  const auto simbody = cost_where(runs, [](const auto& r) { return r.code == "simbody"; });
  const auto tandem = cost_where(runs, [](const auto& r) { return r.code == "tandem"; });
  const auto index3 = cost_where(runs, [](const auto& r) { return r.family() == "index3"; });
  return fmt::format("{:14} {:>5}  {:>9} {:32} {:>9} {:>6}  {:>9} {:>6}  {}\n", runs.front().start,
                     runs.front().loops, seconds(simbody), simbody ? simbody->method : "", seconds(index3),
                     ratio(simbody, index3), seconds(tandem), ratio(simbody, tandem),
                     tandem ? tandem->method : "");
}

}  // namespace

std::vector<LinkageRun> read_linkage_runs(const std::filesystem::path& file) {
  const auto table =
      CsvTable::read(file, {"code", "start", "loops", "method", "rms_error", "seconds", "status"});
  if (table.size() == 0) throw Error(ErrorCode::input_output, "file '" + file.string() + "' has no rows");
  std::vector<LinkageRun> runs;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto row = table[k];
    runs.push_back({row.text("code"), row.text("start"), row.text("method"), row.text("status"),
                    static_cast<int>(row.positive("loops")), row.number("rms_error"),
                    row.positive("seconds")});
  }
  return runs;
}

std::optional<Cost> cost_of(const std::vector<LinkageRun>& runs, double error) {
  std::map<std::string, std::vector<Point>> methods;
  for (const LinkageRun& r : runs)
    if (r.ok()) methods[r.method].push_back({r.seconds, r.error});
  std::optional<Cost> least;
  for (auto& [method, points] : methods) {
    const auto cost = cost_on(pareto_front(std::move(points)), error, method);
    if (cost && (!least || cost->seconds < least->seconds)) least = cost;
  }
  return least;
}

std::string ratios(const std::vector<LinkageRun>& runs) {
  std::string text = fmt::format("Processor time at an error of {:g} m\n", asked);
  text += fmt::format("{:14} {:>5}  {:>9} {:32} {:>9} {:>6}  {:>9} {:>6}\n", "start", "loops", "Simbody",
                      "by", "index3", "times", "tandem", "times");
  std::vector<LinkageRun> same;
  for (const LinkageRun& r : runs) {
    if (!same.empty() && (r.start != same.front().start || r.loops != same.front().loops)) {
      text += line(same);
      same.clear();
    }
    same.push_back(r);
  }
  return text + line(same);
}

}  // namespace tandem::charts
