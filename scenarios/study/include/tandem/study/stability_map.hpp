// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::study {

/// One axis of a map: so many values of a key of the scenario, from one to the other, at equal distances or ratios.
struct MapAxis {
  std::string key;
  double from, to;
  int count;
  bool log = false;

  /// "KEY:FROM:TO:COUNT" or "KEY:FROM:TO:COUNT:log". Throws Error that says what is wrong with it.
  static MapAxis from_text(const std::string& text);
  /// Ascending, to four digits; `own` is among them as it is, if it lies between.
  std::vector<double> values(double own) const;
};

/// The study of a scenario over two of its keys, as a text: its table is `stability_map`, of the columns x, y and
/// spectral_radius, and it has one chart. Where x and y are those of the scenario the chart has a sign.
/// - overrides: of the scenario, "KEY=VALUE".
std::string stability_map(const std::filesystem::path& scenario, const std::vector<std::string>& overrides,
                          const MapAxis& x, const MapAxis& y);

}  // namespace tandem::study
