// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/row_choice.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

RowChoice::RowChoice(const RowRules& rules, double t_start)
    : rules_(rules), tolerance_(t_start), begin_(std::max(rules.from, t_start)) {}

bool RowChoice::takes(double t, bool last) {
  if (tolerance_.before(t, rules_.from) || tolerance_.before(rules_.to, t)) return false;
  if (!(rules_.every > 0.0)) return true;
  const auto due = [this](std::int64_t multiple) {
    return begin_ + static_cast<double>(multiple) * rules_.every;
  };
  const bool is_due = !tolerance_.before(t, due(next_));
  if (!is_due && !last && t != newest_) return false;
  if (is_due) {
    next_ = std::max(next_, static_cast<std::int64_t>(std::floor((t - begin_) / rules_.every)));
    while (!tolerance_.before(t, due(next_))) ++next_;
  }
  newest_ = t;
  return true;
}

void RowChoice::write(ByteWriter& to) const {
  to.put(next_);
  to.put(newest_);
}

void RowChoice::read(ByteReader& from) {
  next_ = from.take<std::int64_t>();
  newest_ = from.take<double>();
  if (next_ < 0 || std::isnan(newest_)) from.refuse("has a recording that waits for no row");
}

}  // namespace tandem
