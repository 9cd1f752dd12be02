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
  QuadraticMap() = default;
  QuadraticMap(std::size_t variables, std::size_t values)
      : variables_(variables),
        values_(values),
        terms_((1 + variables + variables * (variables + 1) / 2) * values),
        scratch_(5 * values) {}

  /// About x by central differences, by steps[j] in variable j. f(x, y) gives the values; x is as it was afterwards.
  template <class Function>
  void expand(std::span<double> x, std::span<const double> steps, const Function& f) {
    const std::span<double> here = term(0), all(scratch_);
    const auto part = [&](std::size_t k) { return all.subspan(k * values_, values_); };
    const auto moved = [&](std::size_t j, std::size_t k, double sign, std::span<double> y) {
      const double xj = x[j], xk = x[k];
      x[j] += sign * steps[j], x[k] += j == k ? 0.0 : sign * steps[k];
      f(x, y);
      x[j] = xj, x[k] = xk;
    };
    f(x, here);
    std::vector<double> sums(variables_ * values_);  // f(x + e_j) + f(x - e_j) - 2 f(x)
    for (std::size_t j = 0; j < variables_; ++j) {
      moved(j, j, 1.0, part(0)), moved(j, j, -1.0, part(1));
      for (std::size_t i = 0; i < values_; ++i) {
        sums[j * values_ + i] = part(0)[i] + part(1)[i] - 2.0 * here[i];
        term(1 + j)[i] = (part(0)[i] - part(1)[i]) / (2.0 * steps[j]);
        pair(j, j)[i] = sums[j * values_ + i] / (2.0 * steps[j] * steps[j]);
      }
      for (std::size_t k = 0; k < j; ++k) {
        moved(j, k, 1.0, part(0)), moved(j, k, -1.0, part(1));
        for (std::size_t i = 0; i < values_; ++i)
          pair(j, k)[i] =
              (part(0)[i] + part(1)[i] - 2.0 * here[i] - sums[j * values_ + i] - sums[k * values_ + i]) /
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
  std::size_t place(std::size_t j, std::size_t k) const { return 1 + variables_ + j * (j + 1) / 2 + k; }
  std::span<double> term(std::size_t number) { return std::span(terms_).subspan(number * values_, values_); }
  std::span<double> pair(std::size_t j, std::size_t k) { return term(place(j, k)); }
  void add(std::size_t number, double factor, std::span<double> y) const {
    const double* const term = terms_.data() + number * values_;
    for (std::size_t i = 0; i < values_; ++i) y[i] += factor * term[i];
  }

  std::size_t variables_ = 0, values_ = 0;
  std::vector<double>
      terms_;  ///< the value, the gradients, and the halves of second derivatives that go with d_j d_k
  std::vector<double> scratch_;
};

}  // namespace tandem
