// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tandem {

namespace {

/// Insertions, deletions, changes and swaps of neighbours that make b of a (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1), before(b.size() + 1), before_that(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_that, before);
    std::swap(before, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({before[j] + 1, row[j - 1] + 1, before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_that[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view text, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = text.size() / 2 + 1;
  const auto longer = [&](const std::string& candidate) {
    return std::max(text.size(), candidate.size()) - std::min(text.size(), candidate.size());
  };
  for (const std::string& candidate : candidates)
    if (longer(candidate) >= best_distance)
      continue;  // it has as many insertions or deletions at least
    else if (const std::size_t d = distance(text, candidate); d < best_distance)
      best_distance = d, best = candidate;
  return best;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 1000;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), most); ++k)
    text += (text.empty() ? "" : ", ") + names[k];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text.empty() ? "none" : text;
}

std::string unknown(const std::string& kind, const std::string& found,
                    const std::vector<std::string>& known) {
  const std::string near = nearest(found, known);
  return kind + " '" + found + "' is not there" + (near.empty() ? "." : "; did you mean '" + near + "'?") +
         " There are: " + listed(known);
}

}  // namespace tandem
