// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/thinning.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::view {
namespace {

constexpr std::size_t most_rows = 200'000;       // that a plot is quick with: 100 on a pixel
constexpr std::size_t most_numbers = 4'000'000;  // about 43 MB of page
constexpr std::size_t fewest_rows = 16;

}  // namespace

Thinning::Thinning(std::size_t rows, std::size_t columns, int every) {
  const std::size_t most = std::clamp(most_numbers / (columns + 1), fewest_rows, most_rows);
  if (every > 0 || rows <= most)
    take(rows, every > 0 ? static_cast<std::size_t>(every) : 1);
  else
    band(rows, most);
  for (const Group& group : groups_) rows_ += group.end - group.begin > 1 ? 2 : 1;
}

void Thinning::take(std::size_t rows, std::size_t step) {
  for (std::size_t k = 0; k < rows; k += step) groups_.push_back({k, k + 1});
  if (rows > 0 && groups_.back().begin != rows - 1) groups_.push_back({rows - 1, rows});
}

void Thinning::band(std::size_t rows, std::size_t most) {
  const std::size_t bands = (most - 2) / 2;
  band_ = (rows - 2 + bands - 1) / bands;
  groups_.push_back({0, 1});
  for (std::size_t k = 1; k < rows - 1; k += band_) groups_.push_back({k, std::min(k + band_, rows - 1)});
  groups_.push_back({rows - 1, rows});
}

std::vector<double> Thinning::bands(const std::vector<double>& values) const {
  std::vector<double> all;
  all.reserve(rows_);
  for (const auto& [begin, end] : groups_) {
    std::size_t low = begin, high = begin;
    for (std::size_t k = begin; k < end; ++k) {
      if (std::isnan(values[low]) || values[k] < values[low]) low = k;
      if (std::isnan(values[high]) || values[k] > values[high]) high = k;
    }
    all.push_back(values[std::min(low, high)]);
    if (end - begin > 1) all.push_back(values[std::max(low, high)]);
  }
  return all;
}

std::vector<double> Thinning::ends(const std::vector<double>& values) const {
  std::vector<double> all;
  all.reserve(rows_);
  for (const auto& [begin, end] : groups_) {
    all.push_back(values[begin]);
    if (end - begin > 1) all.push_back(values[end - 1]);
  }
  return all;
}

}  // namespace tandem::view
