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

namespace {

/// What is tried after a value for which it holds: the other end, or on the way there.
double next(const Search& search, double good) {
  if (search.largest) return search.scan ? std::min(good * *search.scan, search.to) : search.to;
  return search.scan ? std::max(good / *search.scan, search.from) : search.from;
}

void put(RowResult& result, const Search& search, std::optional<double> value) {
  if (value)
    result.metrics[search.column] = *value;
  else
    result.metrics.clear();
}

}  // namespace

double RowRunner::runs_of_row() const {
  if (!table_.search) return 1.0;
  const Search& s = *table_.search;
  const double whole = std::log(s.to / s.from), part = s.scan ? std::log(*s.scan) : whole;
  const double scanned = s.scan ? 0.5 * whole / part : 1.0;  // half of the way
  return 1.0 + scanned + std::max(0.0, std::log2(part / s.precision));
}

std::optional<RowResult> RowRunner::search(const FileValues& row, const std::function<bool()>& going) const {
  const Search& search = *table_.search;
  const double end = search.largest ? search.to : search.from;
  double good = search.largest ? search.from : search.to, bad = end;
  FileValues at = row;
  const auto tried = [&](double value) {
    at[search.column] = value;
    return run_once(at, going);
  };
  auto best = tried(good);
  if (!best || best->status == "refused") return best;
  if (!holds(at, *best)) {
    put(*best, search, search.nowhere);
    best->note = fmt::format("it does not hold at {}{}", good, best->note.empty() ? "" : ": " + best->note);
    best->status = "ok";
    return best;
  }
  const auto try_at = [&](double value) {
    const auto result = tried(value);
    if (result && holds(at, *result))
      good = value, best = result;
    else
      bad = value;
    return result.has_value();
  };
  for (bool failed = false; !failed && good != end;) {
    const double value = next(search, good);
    if (!try_at(value)) return {};
    failed = good != value;
  }
  if (good == end) best->note = fmt::format("it holds at {} too", end);
  while (good != end &&
         std::max(good / bad, bad / good) > 1.0 + search.precision) {  // by halves of the logarithm
    const double middle = std::sqrt(good * bad);
    if (middle == good || middle == bad) break;  // there is no number between
    if (!try_at(middle)) return {};
  }
  put(*best, search, good == end ? search.everywhere.value_or(end) : good);
  return best;
}

}  // namespace tandem::study
