// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "link_rows.hpp"

namespace tandem {
namespace {

/// Newton's form on the nodes t, t - e1, t - e2, ...: the backward divided differences at the new node, n_0 =
/// y and n_i = (n_{i-1} - table_{i-1}) / e_i, follow from those at the node before, and nested multiplication
/// turns them into powers of t' - t. With too few samples to fit (at the start, after a jump) 1/e counts as 0
/// for the missing ones, which leaves a polynomial of lower degree.
template <int Degree>
struct Newton {
  std::int64_t stride;

  struct Distances {
    double e[Degree + 1], reciprocal[Degree + 1];
  };
  Distances prepare(const double* row, std::int64_t fitted) const {
    if (fitted >= Degree) return distances(row, Degree);
    Distances d = distances(row, static_cast<int>(fitted));
    std::fill(d.reciprocal + fitted + 1, d.reciprocal + Degree + 1, 0.0);
    std::fill(d.e + fitted + 1, d.e + Degree + 1, 0.0);
    return d;
  }
  Distances distances(const double* row, int order) const {
    Distances d;
    for (int i = 1; i <= order; ++i) {
      d.e[i] = row[0] - row[-i * stride];
      d.reciprocal[i] = 1.0 / d.e[i];
    }
    return d;
  }
  void fill(const Distances& d, const double* row, const Lane& lane, double* table, double* c) const {
    double n[Degree + 1];
    n[0] = lane.gain * row[Samples::header + lane.output] + lane.offset;
    for (int i = 1; i <= Degree; ++i) n[i] = (n[i - 1] - table[i - 1]) * d.reciprocal[i];
    for (int i = 0; i <= Degree; ++i) table[i] = n[i];
    for (int k = Degree - 1; k >= 1; --k)  // n[k..] <- n[k] + (s + e[k]) * polynomial n[k+1..]
      for (int i = k; i < Degree; ++i) n[i] += d.e[k] * n[i + 1];
    for (int i = 0; i <= Degree; ++i) c[i] = n[i];
  }
};

}  // namespace

template <int Degree>
void Link::extend_lagrange(const History& source) {
  extend_rows(source, Newton<Degree>{source.stride()});
}

template void Link::extend_lagrange<0>(const History&);
template void Link::extend_lagrange<1>(const History&);
template void Link::extend_lagrange<2>(const History&);
template void Link::extend_lagrange<3>(const History&);
template void Link::extend_lagrange<4>(const History&);

}  // namespace tandem
