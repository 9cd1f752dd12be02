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
    Distances d;
    for (int i = 1; i <= Degree; ++i) {
      const bool there = fitted >= Degree || i <= fitted;
      d.e[i] = there ? row[0] - row[-i * stride] : 0.0;
      d.reciprocal[i] = there ? 1.0 / d.e[i] : 0.0;
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
void Link::extend_lagrange(Link& link, NewRows rows) {
  link.extend_rows(rows, Newton<Degree>{link.stride_}, Newton<std::max(Degree, 1)>{link.stride_});
}

template void Link::extend_lagrange<0>(Link&, NewRows);
template void Link::extend_lagrange<1>(Link&, NewRows);
template void Link::extend_lagrange<2>(Link&, NewRows);
template void Link::extend_lagrange<3>(Link&, NewRows);
template void Link::extend_lagrange<4>(Link&, NewRows);

}  // namespace tandem
