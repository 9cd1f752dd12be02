// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/stability_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "tandem/error.hpp"
#include "tandem/text/document.hpp"

namespace tandem::study {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw Error(
      ErrorCode::invalid_argument,
      fmt::format(
          "--map {}: {}; allowed is KEY:FROM:TO:COUNT, with COUNT 2 to 200 and FROM below TO, and :log "
          "behind it where both are above 0",
          text, what));
}

template <class Number>
Number number(const std::string& text, const std::string& part) {
  Number value{};
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc{} || end != part.data() + part.size()) refuse(text, "'" + part + "' is no number");
  return value;
}

std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> all{""};
  for (const char c : text)
    if (c == ':')
      all.emplace_back();
    else
      all.back() += c;
  return all;
}

/// The number of the scenario at a key; not a number if there is none.
double own_value(const std::filesystem::path& scenario, const std::vector<std::string>& overrides,
                 const std::string& key) {
  text::Document document(scenario);
  document.set(overrides);
  return document.table().at_path(key).value<double>().value_or(std::numeric_limits<double>::quiet_NaN());
}

std::string listed(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(fmt::format("{:.17g}", value));
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

MapAxis MapAxis::from_text(const std::string& text) {
  const auto all = parts(text);
  if (all.size() < 4 || all.size() > 5 || (all.size() == 5 && all[4] != "log"))
    refuse(text, "that is no axis");
  const MapAxis axis{all[0], number<double>(text, all[1]), number<double>(text, all[2]),
                     number<int>(text, all[3]), all.size() == 5};
  constexpr int most = 200;
  if (axis.key.empty()) refuse(text, "the key is missing");
  if (!(axis.from < axis.to) || !std::isfinite(axis.to - axis.from)) refuse(text, "it does not rise");
  if (axis.count < 2 || axis.count > most) refuse(text, fmt::format("COUNT is {}", axis.count));
  if (axis.log && axis.from <= 0.0) refuse(text, fmt::format("FROM is {}", axis.from));
  return axis;
}

std::vector<double> MapAxis::values(double own) const {
  const auto four_digits = [](double value) { return std::stod(fmt::format("{:.4g}", value)); };
  std::vector<double> all;
  for (int k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / (count - 1);
    all.push_back(four_digits(log ? from * std::pow(to / from, part) : from + part * (to - from)));
  }
  const auto same = [own](double value) { return std::abs(value - own) <= 1e-9 * std::abs(own); };
  if (from < own && own < to) std::erase_if(all, same), all.push_back(own);
  std::sort(all.begin(), all.end());
  return all;
}

std::string stability_map(const std::filesystem::path& scenario, const std::vector<std::string>& overrides,
                          const MapAxis& x, const MapAxis& y) {
  const double own_x = own_value(scenario, overrides, x.key), own_y = own_value(scenario, overrides, y.key);
  const std::string own =
      std::isfinite(own_x) && std::isfinite(own_y)
          ? fmt::format("signs = [{{ when = \"x == {:.17g} && y == {:.17g}\", name = \"the scenario\" }}]\n",
                        own_x, own_y)
          : "";
  return fmt::format(R"toml(scenario = "{}"
columns = ["x", "y", "spectral_radius"]

[set]
"{}" = "$x"
"{}" = "$y"

[metrics]
spectral_radius = {{}}

[[tables.stability_map.blocks]]
axes = [{{ y = [{}] }}, {{ x = [{}] }}]

[names]
x = "{}"
y = "{}"
spectral_radius = "spectral radius"

[[charts]]
name = "stability_map"
kind = "map"
table = "stability_map"
title = "Spectral radius of a super-step: stable up to 1"
rows = "y"
columns = "x"
value = "spectral_radius"
limits = [0.9, 0.99, 1.000000001, 1.01, 1.1]
{})toml",
                     scenario.filename().string(), x.key, y.key, listed(y.values(own_y)),
                     listed(x.values(own_x)), x.key, y.key, own);
}

}  // namespace tandem::study
