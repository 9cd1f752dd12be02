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

Courses::Cubic Courses::cubic(const Course& course) const {
  const std::vector<double>& y = table_.columns[course.values];
  const std::vector<double>& slopes = table_.columns[*course.derivatives];
  const double begin = table_.times[row_ - 1], h = table_.times[row_] - begin, rise = y[row_] - y[row_ - 1];
  const double d = h * slopes[row_ - 1], e = h * slopes[row_];
  return {(time_ - begin) / h, h, y[row_ - 1], d, 3.0 * rise - 2.0 * d - e, d + e - 2.0 * rise};
}

double Courses::value(const Course& course) const {
  const std::vector<double>& y = table_.columns[course.values];
  if (exact()) return y[row_];
  if (course.derivatives) {
    const auto [s, h, begin, d, c, e] = cubic(course);
    return begin + s * (d + s * (c + s * e));
  }
  const double begin = table_.times[row_ - 1], s = (time_ - begin) / (table_.times[row_] - begin);
  return y[row_ - 1] + s * (y[row_] - y[row_ - 1]);
}

double Courses::slope(const Course& course) const {
  if (exact()) return table_.columns[*course.derivatives][row_];
  const auto [s, h, begin, d, c, e] = cubic(course);
  return (d + s * (2.0 * c + s * 3.0 * e)) / h;
}

}  // namespace tandem::scenario
