// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cubic.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {
namespace {

/// Slopes of the straight lines, at each point that of the line to its right; of the last that to its left.
std::vector<double> straight(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> slope;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) slope.push_back((y[k + 1] - y[k]) / (x[k + 1] - x[k]));
  slope.push_back(slope.back());
  return slope;
}

std::vector<double> monotone(const std::vector<double>& x, const std::vector<double>& y) {
  const auto line = straight(x, y);
  std::vector<double> slope = line;
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    slope[k] = harmonic(line[k - 1], x[k] - x[k - 1], line[k], x[k + 1] - x[k]);
  return slope;
}

void check(const std::string& owner, const std::vector<double>& x, const std::vector<double>& y) {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::invalid_argument, owner + " " + what);
  };
  if (x.size() != y.size())
    refuse(fmt::format("has {} points and {} values; allowed is as many", x.size(), y.size()));
  if (x.size() < 2) refuse(fmt::format("has {} points; allowed is 2 or more", x.size()));
  for (std::size_t k = 1; k < x.size(); ++k)
    if (!(x[k] > x[k - 1]))
      refuse(fmt::format("has the point {} after {}; allowed is an order that ascends", x[k], x[k - 1]));
}

}  // namespace

Curve::Curve(const std::string& owner, std::vector<double> x, std::vector<double> y, Between between,
             Beyond beyond)
    : x_(std::move(x)), y_(std::move(y)), between_(between), beyond_(beyond) {
  check(owner, x_, y_);
  slope_ = between == Between::linear ? straight(x_, y_) : monotone(x_, y_);
}

double Curve::outside(std::size_t end, double x) const {
  return beyond_ == Beyond::hold ? y_[end] : y_[end] + slope_[end] * (x - x_[end]);
}

double Curve::operator()(double x) const {
  if (std::isnan(x)) return x;
  if (x <= x_.front()) return outside(0, x);
  if (x >= x_.back()) return outside(x_.size() - 1, x);
  const auto k = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1);
  if (between_ == Between::linear) return y_[k] + slope_[k] * (x - x_[k]);
  const double h = x_[k + 1] - x_[k];
  return hermite({h, y_[k], slope_[k], y_[k + 1], slope_[k + 1]}, (x - x_[k]) / h);
}

}  // namespace tandem::engine
