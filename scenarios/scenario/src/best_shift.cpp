// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "best_shift.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "tandem/scenario/courses.hpp"

namespace tandem::scenario {
namespace {

/// Infinite where fewer times than needed are compared, or no value of a column.
double mismatch(const Comparison& comparison, std::size_t needed) {
  double sum = comparison.times < needed ? std::numeric_limits<double>::infinity() : 0.0;
  for (const Difference& d : comparison.columns)
    sum += d.compared > 0 ? d.relative_rms * d.relative_rms : std::numeric_limits<double>::infinity();
  return sum;
}

/// The shortest time in which a column goes up and down once, by how often it turns [s]; 0: none does.
double shortest_cycle(const TimeTable& table, const std::vector<std::string>& names) {
  const Courses courses(table);
  std::size_t most = 0;
  for (const std::string& name : names) {
    const std::vector<double>& x = table.columns[courses.course(name).values];
    std::size_t turns = 0;
    bool rises = false, begun = false;
    for (std::size_t row = 1; row < x.size(); ++row)
      if (x[row] != x[row - 1] && std::exchange(rises, x[row] > x[row - 1]) != (x[row] > x[row - 1]))
        turns += std::exchange(begun, true) ? 1 : 0;
    most = std::max(most, turns);
  }
  return most > 0 ? 2.0 * (table.times.back() - table.times.front()) / static_cast<double>(most) : 0.0;
}

/// So many to each side: a sixteenth of the shortest cycle apart, where that is not too much work.
int scan_steps(double most, double cycle, std::size_t values) {
  constexpr double least = 32.0, work = 5e7;
  const double wanted = cycle > 0.0 ? std::ceil(16.0 * most / cycle) : least;
  return static_cast<int>(std::clamp(wanted, least, std::max(least, work / static_cast<double>(values))));
}

/// Where the scan is lower than on both sides, the lowest first.
std::vector<std::size_t> valleys(const std::vector<double>& sums) {
  constexpr std::size_t most = 8;
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < sums.size(); ++k)
    if ((k == 0 || sums[k] <= sums[k - 1]) && (k + 1 == sums.size() || sums[k] <= sums[k + 1]))
      all.push_back(k);
  std::ranges::stable_sort(all, {}, [&](std::size_t k) { return sums[k]; });
  if (all.size() > most) all.resize(most);
  return all;
}

}  // namespace

double best_shift(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& names, double most,
                  const std::function<Comparison(double)>& shifted) {
  const auto length = [](const TimeTable& of) { return of.times.back() - of.times.front(); };
  most = std::min(most, std::max(length(a), length(b)));
  const int steps =
      scan_steps(most, shortest_cycle(b, names), (a.times.size() + b.times.size()) * names.size());
  const auto at = [&](int k) { return most * k / steps; };
  std::vector<std::pair<std::size_t, double>> scan;  // times, and mismatch if these are enough
  for (int k = -steps; k <= steps; ++k) {
    const Comparison one = shifted(at(k));
    scan.emplace_back(one.times, mismatch(one, 0));
  }
  const std::size_t needed = (std::ranges::max(scan).first + 1) / 2;
  std::vector<double> sums;
  for (const auto& [times, sum] : scan)
    sums.push_back(times < needed ? std::numeric_limits<double>::infinity() : sum);
  double best = 0.0, least = sums[static_cast<std::size_t>(steps)];
  const auto take = [&](double shift, double sum) {
    if (sum < least) best = shift, least = sum;
  };
  for (const std::size_t valley : valleys(sums)) {
    const int k = static_cast<int>(valley) - steps;
    take(at(k), sums[valley]);
    const auto [shift, sum] =
        boost::math::tools::brent_find_minima([&](double here) { return mismatch(shifted(here), needed); },
                                              std::max(-most, at(k - 1)), std::min(most, at(k + 1)), 24);
    take(shift, sum);
  }
  return best;
}

}  // namespace tandem::scenario
