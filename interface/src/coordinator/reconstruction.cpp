// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/reconstruction.hpp"

#include <algorithm>
#include <charconv>

#include "tandem/error.hpp"

namespace tandem {
namespace {

using Kind = Reconstruction::Kind;

/// Reads a whole number without sign, leading zero or anything after it; false otherwise.
bool whole_number(std::string_view text, int& number) {
  if (text.empty() || (text.size() > 1 && text[0] == '0')) return false;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  return code == std::errc{} && end == text.data() + text.size() && number >= 0;
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool parse_least_squares(std::string_view rest, Reconstruction& r) {
  const auto bar = rest.find('_');
  return bar != std::string_view::npos && whole_number(rest.substr(0, bar), r.degree) &&
         whole_number(rest.substr(bar + 1), r.extra) && r.degree <= 4 && r.extra >= 1 && r.extra <= 16;
}

}  // namespace

Reconstruction Reconstruction::parse(std::string_view text) {
  if (text == "hermite") return {Kind::hermite};
  if (text == "mean") return {Kind::mean};
  if (text == "matched_hold") return {Kind::matched_hold};
  std::string_view rest = text;
  Reconstruction r;
  if (take_prefix(rest, "lagrange") && whole_number(rest, r.degree) && r.degree <= 4) return r;
  rest = text;
  r = {Kind::least_squares};
  if (take_prefix(rest, "least_squares") && parse_least_squares(rest, r)) return r;
  throw Error(ErrorCode::invalid_argument, "reconstruction '" + std::string(text) +
                                               "' is not one of lagrange0 to lagrange4, hermite, mean, "
                                               "least_squaresD_EXTRA (degree D 0 to 4, EXTRA 1 "
                                               "to 16 samples), matched_hold");
}

const std::vector<std::string>& Reconstruction::words() {
  static const std::vector<std::string> all = {"lagrange0", "lagrange1", "lagrange2", "lagrange3",
                                               "lagrange4", "hermite",   "mean",      "matched_hold"};
  return all;
}

std::string Reconstruction::name() const {
  switch (kind) {
    case Kind::hermite:
      return "hermite";
    case Kind::mean:
      return "mean";
    case Kind::matched_hold:
      return "matched_hold";
    case Kind::least_squares:
      return "least_squares" + std::to_string(degree) + "_" + std::to_string(extra);
    case Kind::held:
      return "held";
    case Kind::taylor:
      return "taylor";
    case Kind::lagrange:
      break;
  }
  return "lagrange" + std::to_string(degree);
}

int Reconstruction::samples() const {
  if (kind == Kind::hermite) return 2;
  return follows_samples() ? degree + 1 + extra : 1;
}

int Reconstruction::polynomial_degree() const {
  return kind == Kind::hermite ? 3 : kind == Kind::taylor ? 2 : degree;
}

int Reconstruction::derivatives_at_start() const {
  if (kind == Kind::hermite) return 2;
  return std::max(0, degree - 1);
}

}  // namespace tandem
