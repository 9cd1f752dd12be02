// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "../number_text.hpp"
#include "known_units.hpp"
#include "tandem/coordinator/units.hpp"

namespace tandem {
namespace {

using Exponents = std::array<int, 8>;

Exponents exponents_of(std::string_view quantity) {
  constexpr std::array<std::pair<std::string_view, Exponents>, 21> all = {{
      {"ratio", {}},
      {"time", {0, 0, 1}},
      {"frequency", {0, 0, -1}},
      {"length", {0, 1}},
      {"speed", {0, 1, -1}},
      {"acceleration", {0, 1, -2}},
      {"angle", {0, 0, 0, 0, 0, 0, 0, 1}},
      {"angular speed", {0, 0, -1, 0, 0, 0, 0, 1}},
      {"angular acceleration", {0, 0, -2, 0, 0, 0, 0, 1}},
      {"mass", {1}},
      {"mass flow", {1, 0, -1}},
      {"force", {1, 1, -2}},
      {"torque", {1, 2, -2}},
      {"pressure", {1, -1, -2}},
      {"power", {1, 2, -3}},
      {"energy", {1, 2, -2}},
      {"temperature", {0, 0, 0, 0, 1}},
      {"voltage", {1, 2, -3, -1}},
      {"current", {0, 0, 0, 1}},
      {"amount of substance", {0, 0, 0, 0, 0, 1}},
      {"luminous intensity", {0, 0, 0, 0, 0, 0, 1}},
  }};
  return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == quantity; })->second;
}

BaseUnit base_of(const KnownUnit& unit) { return {exponents_of(unit.quantity), unit.scale, unit.zero}; }

constexpr std::string_view plus_offset = " + ";

/// `to` times a power of `by`, whose zero does not count then. False: that is beyond any unit.
bool multiply(BaseUnit& to, const BaseUnit& by, int power) {
  constexpr int most = 99;
  for (std::size_t k = 0; k < to.exponents.size(); ++k)
    if (std::abs(to.exponents[k] += power * by.exponents[k]) > most) return false;
  to.factor *= std::pow(by.factor, power);
  return to.factor > 0.0 && std::isfinite(to.factor);
}

/// product = factor { [blank, '*' or '.'] factor | '/' factor }; factor = (number | name | '(' product ')')
/// [['^'] whole].
class ProductReader {
 public:
  explicit ProductReader(std::string_view text) : left_(text) {}

  std::optional<BaseUnit> read() {
    auto all = product(0);
    return all && left_.empty() ? all : std::nullopt;
  }

 private:
  std::optional<BaseUnit> product(int depth) {
    BaseUnit all;
    for (int sign = 1;;) {
      const auto one = factor(depth);
      if (!one) return std::nullopt;
      const auto power = exponent();
      if (!power) return std::nullopt;
      if (!multiply(all, *one, sign * *power)) return std::nullopt;
      if (left_.empty() || left_.front() == ')') return all;
      sign = left_.front() == '/' ? -1 : 1;
      if (std::string_view("/ *.").find(left_.front()) == std::string_view::npos) return std::nullopt;
      const bool dot = left_.front() == '.';
      left_.remove_prefix(1);
      if (dot && is_digit(left_)) return std::nullopt;  // "m^1.5"
    }
  }

  std::optional<BaseUnit> factor(int depth) {
    constexpr int deepest = 8;
    if (left_.starts_with('(')) {
      left_.remove_prefix(1);
      auto inner = depth < deepest ? product(depth + 1) : std::nullopt;
      if (!inner || !left_.starts_with(')')) return std::nullopt;
      left_.remove_prefix(1);
      return inner;
    }
    return is_digit(left_) ? number() : name();
  }

  std::optional<BaseUnit> number() {
    BaseUnit one;
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), one.factor);
    if (error != std::errc() || !(one.factor > 0.0) || !std::isfinite(one.factor)) return std::nullopt;
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return one;
  }

  std::optional<BaseUnit> name() {
    const auto end = std::min(left_.find_first_of("0123456789^ */.()-"), left_.size());
    const KnownUnit* unit = known_unit(left_.substr(0, end));
    if (!unit) return std::nullopt;
    left_.remove_prefix(end);
    return base_of(*unit);
  }

  std::optional<int> exponent() {
    const bool marked = left_.starts_with('^');
    if (marked) left_.remove_prefix(1);
    if (!marked && !is_digit(left_) && !(left_.starts_with('-') && is_digit(left_.substr(1)))) return 1;
    int power = 0;
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), power);
    if (error != std::errc() || std::abs(power) > 99) return std::nullopt;
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return power;
  }

  static bool is_digit(std::string_view text) {
    return !text.empty() && text.front() >= '0' && text.front() <= '9';
  }

  std::string_view left_;
};

/// Files give factors in some digits.
bool is_near(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)); }

bool are_same(const BaseUnit& a, const BaseUnit& b) {
  return a.exponents == b.exponents && is_near(a.factor, b.factor) && is_near(a.offset, b.offset);
}

/// The first of its quantity; null: there is none, or units of several quantities (N m, J) are the same.
const KnownUnit* only_known(const BaseUnit& unit) {
  const KnownUnit* found = nullptr;
  for (const KnownUnit& known : known_units()) {
    if (!are_same(base_of(known), unit)) continue;
    if (found && found->quantity != known.quantity) return nullptr;
    if (!found) found = &known;
  }
  return found;
}

}  // namespace

std::optional<BaseUnit> base_unit(std::string_view text) {
  if (const KnownUnit* known = known_unit(text)) return base_of(*known);
  const auto plus = text.find(plus_offset);
  auto unit = ProductReader(text.substr(0, plus)).read();
  if (!unit || plus == std::string_view::npos) return unit;
  text.remove_prefix(plus + plus_offset.size());
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), unit->offset);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(unit->offset);
  return is_number ? unit : std::nullopt;
}

std::string unit_text(const BaseUnit& unit) {
  if (const KnownUnit* known = only_known(unit)) return std::string(known->name);
  std::string text = unit.factor == 1.0 ? "" : number_text(unit.factor);
  for (std::size_t k = 0; k < unit.exponents.size(); ++k) {
    const int power = unit.exponents[k];
    if (power == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(BaseUnit::names[k]);
    if (power != 1) text += "^" + std::to_string(power);
  }
  return unit.offset == 0.0 ? text : text + std::string(plus_offset) + number_text(unit.offset);
}

std::string unit_text(std::string_view name, const BaseUnit& means) {
  constexpr std::size_t angle = 7;
  auto here = base_unit(name);
  if (!here) return unit_text(means);
  here->exponents[angle] = means.exponents[angle];
  return are_same(*here, means) ? std::string(name) : unit_text(means);
}

}  // namespace tandem
