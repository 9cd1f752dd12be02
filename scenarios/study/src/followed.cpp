// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "followed.hpp"

#include <limits>

#include "tandem/error.hpp"

namespace tandem::study {

void Followed::add(const text::TimeTable& table, const std::string& output, bool slope) {
  scenario::Courses courses(table);
  const auto course = courses.course(output);
  if (slope && !course.derivatives)
    throw Error(ErrorCode::invalid_argument,
                output + " gives no derivative; allowed is der(X) of an output that does");
  const auto& rows = table.columns[slope ? *course.derivatives : course.values];
  followers_.push_back({std::move(courses), course, slope, table.times == times_ ? &rows : nullptr});
  values_.push_back(0.0);
}

bool Followed::move_to(std::size_t row) {
  const double t = times_[row];
  const bool again = row > 0 && times_[row - 1] == t;
  bool known = true;
  for (std::size_t k = 0; k < followers_.size(); ++k) {
    Follower& one = followers_[k];
    if (one.rows) {
      values_[k] = (*one.rows)[row];
      continue;
    }
    const bool covered = one.courses.covers(t);
    if (covered) one.courses.move_to(t, again);
    if (covered && (one.courses.exact() || one.course.derivatives)) {
      values_[k] = one.slope ? one.courses.slope(one.course) : one.courses.value(one.course);
    } else {
      values_[k] = std::numeric_limits<double>::quiet_NaN();
      known = false;
    }
  }
  return known;
}

}  // namespace tandem::study
