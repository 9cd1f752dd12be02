// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "quadratic_set.hpp"

#include <map>

namespace tandem::mbs {

void Quadratic::add(const Form& f, double factor) {
  constant += factor * f.constant;
  for (const auto& [i, c] : f.terms) linear.push_back({factor * c, i});
}

void Quadratic::add_product(const Form& a, const Form& b, double factor) {
  add(b, factor * a.constant);
  for (const auto& [i, c] : a.terms) {
    if (b.constant != 0.0) linear.push_back({factor * c * b.constant, i});
    for (const auto& [j, d] : b.terms) products.push_back({factor * c * d, i, j});
  }
}

void Quadratic::add_product(const Forms& a, const Forms& b, double factor) {
  for (std::size_t k = 0; k < a.size(); ++k) add_product(a[k], b[k], factor);
}

/// What the derivative by each coordinate is, summed: c + sum h q_j.
void QuadraticSet::add(const Quadratic& e) {
  std::map<int, double> constants;
  std::map<int, std::map<int, double>> slopes;
  for (const auto& [c, i] : e.linear) constants[i] += c;
  for (const auto& [c, i, j] : e.products) slopes[i][j] += c, slopes[j][i] += c;
  for (const auto& [i, unused] : slopes) constants.try_emplace(i, 0.0);
  for (const auto& [i, c] : constants) {
    for (const auto& [j, h] : slopes[i])
      if (h != 0.0) slopes_.push_back({h, j});
    const auto end = static_cast<int>(slopes_.size());
    if (c != 0.0 || end > (entries_.empty() ? 0 : entries_.back().slopes_end))
      entries_.push_back({c, i, end});
  }
  equations_.push_back({e.constant, e.input, static_cast<int>(entries_.size())});
  offs_.push_back(e.off);
}

std::vector<int> QuadraticSet::coordinates(int equation) const {
  std::vector<int> list;
  for (int k = equation > 0 ? equations_[equation - 1].entries_end : 0; k < equations_[equation].entries_end;
       ++k)
    list.push_back(entries_[k].i);
  return list;
}

/// phi = constant + sum q_i (c_i + d phi / d q_i) / 2.
void QuadraticSet::values(const double* q, double* phi, double* jacobian) const {
  const int* to = to_.data();
  const Entry* entry = entries_.data();
  const Slope* slope = slopes_.data();
  phi += first_;
  for (const Equation& e : equations_) {
    double twice = 0.0;
    for (const Entry* end = entries_.data() + e.entries_end; entry < end; ++entry) {
      double by = entry->c;
      for (const Slope* last = slopes_.data() + entry->slopes_end; slope < last; ++slope)
        by += slope->h * q[slope->j];
      jacobian[*to++] = by;
      twice += q[entry->i] * (entry->c + by);
    }
    *phi = e.constant + 0.5 * twice;
    if (e.input >= 0) *phi -= inputs_[static_cast<std::size_t>(e.input)].value;
    ++phi;
  }
}

void QuadraticSet::rates(double* phi_t) const {
  phi_t += first_;
  for (const Equation& e : equations_) {
    if (e.input >= 0) *phi_t = -inputs_[static_cast<std::size_t>(e.input)].rate;
    ++phi_t;
  }
}

Off QuadraticSet::off(int equation, const double* q, double phi) const {
  const OffOf& off = offs_[static_cast<std::size_t>(equation)];
  return off ? off(q, phi) : ConstraintSet::off(equation, q, phi);
}

void QuadraticSet::accelerations(const double*, const double* v, double* gamma) const {
  const Entry* entry = entries_.data();
  const Slope* slope = slopes_.data();
  gamma += first_;
  for (const Equation& e : equations_) {
    double value = 0.0;
    for (const Entry* end = entries_.data() + e.entries_end; entry < end; ++entry) {
      double by = 0.0;
      for (const Slope* last = slopes_.data() + entry->slopes_end; slope < last; ++slope)
        by += slope->h * v[slope->j];
      value += v[entry->i] * by;
    }
    if (e.input >= 0) value -= inputs_[static_cast<std::size_t>(e.input)].acceleration;
    *gamma++ = value;
  }
}

}  // namespace tandem::mbs
