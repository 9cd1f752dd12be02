// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/courses.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::scenario {

Courses::Courses(const text::TimeTable& table) : table_(table), tolerance_(table.times.front()) {
  for (std::size_t k = 0; k < table.names.size(); ++k) index_.emplace(table.names[k], k);
}

Course Courses::course(const std::string& name) const {
  const auto it = index_.find(name);
  if (it == index_.end())
    throw Error(ErrorCode::invalid_argument,
                table_.file.string() + ": " + unknown("column", name, table_.names));
  const auto derivatives = index_.find("der(" + name + ")");
  if (derivatives == index_.end()) return {it->second, {}};
  return {it->second, derivatives->second};
}

std::size_t Courses::count_between(double begin, double end) const {
  return static_cast<std::size_t>(std::count_if(table_.times.begin(), table_.times.end(), [&](double t) {
    return !tolerance_.before(t, begin) && !tolerance_.before(end, t);
  }));
}

void Courses::move_to(double t, bool again) {
  while (row_ + 1 < table_.times.size() && tolerance_.before(table_.times[row_], t)) ++row_;
  while (again && row_ + 1 < table_.times.size() && !tolerance_.before(t, table_.times[row_ + 1])) ++row_;
  time_ = t;
}

double Courses::value(const Course& course) const {
  const std::vector<double>& y = table_.columns[course.values];
  if (exact()) return y[row_];
  const double begin = table_.times[row_ - 1], h = table_.times[row_] - begin, s = (time_ - begin) / h;
  const double rise = y[row_] - y[row_ - 1];
  if (!course.derivatives) return y[row_ - 1] + s * rise;
  const std::vector<double>& slopes = table_.columns[*course.derivatives];
  const double d = h * slopes[row_ - 1], e = h * slopes[row_];
  return y[row_ - 1] + s * (d + s * (3.0 * rise - 2.0 * d - e + s * (d + e - 2.0 * rise)));
}

}  // namespace tandem::scenario
