// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "tandem/bytes.hpp"

namespace tandem {

/// The second-order Taylor polynomial of a function of several variables with several values.
class QuadraticMap {
 public:
  QuadraticMap(std::size_t variables, std::size_t values)
      : variables_(variables),
        values_(values),
        terms_((1 + variables + variables * (variables + 1) / 2) * values),
        scratch_((2 + variables) * values) {}

  /// About x by central differences, by steps[j] in variable j. f(x, y) gives the values; x is as it was afterwards.
  template <class Function>
  void expand(std::span<double> x, std::span<const double> steps, const Function& f) {
    f(x, term(0));
    for (std::size_t j = 0; j < variables_; ++j) {
      look(x, steps, j, j, f);
      for (std::size_t i = 0; i < values_; ++i) {
        scratch(2 + j)[i] = scratch(0)[i] + scratch(1)[i] - 2.0 * term(0)[i];
        term(1 + j)[i] = (scratch(0)[i] - scratch(1)[i]) / (2.0 * steps[j]);
        pair(j, j)[i] = scratch(2 + j)[i] / (2.0 * steps[j] * steps[j]);
      }
      for (std::size_t k = 0; k < j; ++k) {
        look(x, steps, j, k, f);
        for (std::size_t i = 0; i < values_; ++i)
          pair(j, k)[i] =
              (scratch(0)[i] + scratch(1)[i] - 2.0 * term(0)[i] - scratch(2 + j)[i] - scratch(2 + k)[i]) /
              (2.0 * steps[j] * steps[k]);
      }
    }
  }

  double value(std::size_t number) const { return terms_[number]; }  ///< at x
  /// So far beside x.
  void values(std::span<const double> d, std::span<double> y) const {
    std::copy_n(terms_.begin(), values_, y.begin());
    for (std::size_t j = 0; j < d.size(); ++j) {
      add(1 + j, d[j], y);
      for (std::size_t k = 0; k <= j; ++k) add(place(j, k), d[j] * d[k], y);
    }
  }

  void write(ByteWriter& to) const { to.put_doubles(terms_); }
  void read(ByteReader& from) {
    for (double& one : terms_) one = from.take<double>();
  }

 private:
  /// A step forward in j and k, and one back.
  template <class Function>
  void look(std::span<double> x, std::span<const double> steps, std::size_t j, std::size_t k,
            const Function& f) {
    const double xj = x[j], xk = x[k];
    for (const double sign : {1.0, -1.0}) {
      x[j] = xj + sign * steps[j];
      if (k != j) x[k] = xk + sign * steps[k];
      f(x, scratch(sign > 0.0 ? 0 : 1));
    }
    x[j] = xj, x[k] = xk;
  }
  /// What f gives a step on, and back; then of each variable f(x + e_j) + f(x - e_j) - 2 f(x).
  std::span<double> scratch(std::size_t number) {
    return std::span(scratch_).subspan(number * values_, values_);
  }
  std::size_t place(std::size_t j, std::size_t k) const { return 1 + variables_ + j * (j + 1) / 2 + k; }
  std::span<double> term(std::size_t number) { return std::span(terms_).subspan(number * values_, values_); }
  std::span<double> pair(std::size_t j, std::size_t k) { return term(place(j, k)); }
  void add(std::size_t number, double factor, std::span<double> y) const {
    const double* const term = terms_.data() + number * values_;
    for (std::size_t i = 0; i < values_; ++i) y[i] += factor * term[i];
  }

  std::size_t variables_, values_;
  std::vector<double>
      terms_;  ///< the value, the gradients, and the halves of second derivatives that go with d_j d_k
  std::vector<double> scratch_;
};

}  // namespace tandem
