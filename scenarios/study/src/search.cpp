// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "row_run.hpp"

namespace tandem::study {

bool RowRunner::holds(const FileValues& row, const RowResult& result) const {
  if (result.status != "ok") return false;
  FileValues values = row;
  values.insert(result.metrics.begin(), result.metrics.end());
  const Formula& holds = table_.search->holds;
  return is_known(holds, values) && value_of(holds, values) != 0.0;
}

/// By bisection in the logarithm of the value, between one for which it holds and one for which it does not.
std::optional<RowResult> RowRunner::search(const FileValues& row, const std::function<bool()>& going) const {
  const Search& search = *table_.search;
  double good = search.largest ? search.from : search.to, bad = search.largest ? search.to : search.from;
  FileValues at = row;
  const auto tried = [&](double value) {
    at[search.column] = value;
    return run_once(at, going);
  };
  auto best = tried(good);
  if (!best || best->status == "refused") return best;
  if (!holds(at, *best)) {
    best->metrics.clear();
    best->note = fmt::format("it does not hold at {}{}", good, best->note.empty() ? "" : ": " + best->note);
    best->status = "ok";
    return best;
  }
  auto far = tried(bad);
  if (!far) return {};
  if (holds(at, *far)) {
    best = far, good = bad;
    best->note = fmt::format("it holds at {} too", bad);
  }
  while (std::max(good / bad, bad / good) > 1.0 + search.precision) {
    const double middle = std::sqrt(good * bad);
    if (middle == good || middle == bad) break;  // there is no number between
    const auto result = tried(middle);
    if (!result) return {};
    if (holds(at, *result))
      good = middle, best = result;
    else
      bad = middle;
  }
  best->metrics[search.column] = good;
  return best;
}

}  // namespace tandem::study
