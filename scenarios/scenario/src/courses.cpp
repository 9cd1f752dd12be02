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
  exact_ = row_ == 0 || !tolerance_.before(t, table_.times[row_]);
  if (exact_) return;
  length_ = table_.times[row_] - table_.times[row_ - 1];
  s_ = (t - table_.times[row_ - 1]) / length_;
}

const Course::Cubic& Courses::cubic(const Course& course) const {
  if (course.cubic.row == row_) return course.cubic;
  const std::vector<double>& y = table_.columns[course.values];
  const std::vector<double>& slopes = table_.columns[*course.derivatives];
  const double rise = y[row_] - y[row_ - 1], d = length_ * slopes[row_ - 1], e = length_ * slopes[row_];
  return course.cubic = {row_, y[row_ - 1], d, 3.0 * rise - 2.0 * d - e, d + e - 2.0 * rise};
}

double Courses::value(const Course& course) const {
  const std::vector<double>& y = table_.columns[course.values];
  if (exact_) return y[row_];
  if (!course.derivatives) return y[row_ - 1] + s_ * (y[row_] - y[row_ - 1]);
  const auto& [row, begin, d, c, e] = cubic(course);
  return begin + s_ * (d + s_ * (c + s_ * e));
}

double Courses::slope(const Course& course) const {
  if (exact_) return table_.columns[*course.derivatives][row_];
  const auto& [row, begin, d, c, e] = cubic(course);
  return (d + s_ * (2.0 * c + s_ * 3.0 * e)) / length_;
}

}  // namespace tandem::scenario
