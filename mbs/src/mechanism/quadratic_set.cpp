// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "quadratic_set.hpp"

#include <algorithm>

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

void QuadraticSet::add(const Quadratic& e) {
  std::copy_if(e.linear.begin(), e.linear.end(), std::back_inserter(linear_),
               [](const auto& term) { return term.c != 0.0; });
  std::copy_if(e.products.begin(), e.products.end(), std::back_inserter(products_),
               [](const auto& term) { return term.c != 0.0; });
  equations_.push_back(
      {e.constant, e.input, static_cast<int>(linear_.size()), static_cast<int>(products_.size())});
}

/// One for each linear term, then two for each product.
std::vector<int> QuadraticSet::coordinates(int equation) const {
  const Equation before = equation > 0 ? equations_[equation - 1] : Equation{};
  std::vector<int> list;
  for (int k = before.linear_end; k < equations_[equation].linear_end; ++k) list.push_back(linear_[k].i);
  for (int k = before.products_end; k < equations_[equation].products_end; ++k)
    list.insert(list.end(), {products_[k].i, products_[k].j});
  return list;
}

/// A coordinate may occur in several terms of an equation, so entries add up.
void QuadraticSet::values(const double* q, double* phi, double* jacobian) const {
  for (const int to : to_) jacobian[to] = 0.0;
  const int* to = to_.data();
  const auto* l = linear_.data();
  const auto* p = products_.data();
  phi += first_;
  for (const Equation& e : equations_) {
    double value = e.constant;
    for (const auto* end = linear_.data() + e.linear_end; l < end; ++l) {
      value += l->c * q[l->i];
      jacobian[*to++] += l->c;
    }
    for (const auto* end = products_.data() + e.products_end; p < end; ++p, to += 2) {
      const double a = p->c * q[p->i], b = q[p->j];
      value += a * b;
      jacobian[to[0]] += p->c * b;
      jacobian[to[1]] += a;
    }
    if (e.input >= 0) value -= inputs_[static_cast<std::size_t>(e.input)].value;
    *phi++ = value;
  }
}

void QuadraticSet::rates(double* phi_t) const {
  phi_t += first_;
  for (const Equation& e : equations_) {
    if (e.input >= 0) *phi_t = -inputs_[static_cast<std::size_t>(e.input)].rate;
    ++phi_t;
  }
}

void QuadraticSet::accelerations(const double*, const double* v, double* gamma) const {
  const auto* p = products_.data();
  gamma += first_;
  for (const Equation& e : equations_) {
    double value = 0.0;
    for (const auto* end = products_.data() + e.products_end; p < end; ++p)
      value += 2.0 * p->c * v[p->i] * v[p->j];
    if (e.input >= 0) value -= inputs_[static_cast<std::size_t>(e.input)].acceleration;
    *gamma++ = value;
  }
}

}  // namespace tandem::mbs
