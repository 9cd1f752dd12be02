// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "link_rows.hpp"

namespace tandem {
namespace {

/// The parabola of one sample, by its own derivatives.
struct Parabola {
  int outputs;

  int prepare(const double*, std::int64_t) const { return 0; }

  void fill(int, const double* row, const Lane& lane, double*, double* c) const {
    const double* const value = row + Samples::header + lane.output;
    c[0] = lane.gain * value[0] + lane.offset;
    c[1] = lane.gain * value[outputs];
    c[2] = lane.gain * value[2 * outputs] / 2.0;
  }
};

}  // namespace

void Link::extend_taylor(Link& link, NewRows rows) {
  const Parabola parabola{link.samples_->outputs()};
  link.extend_rows(rows, parabola, parabola);
}

}  // namespace tandem
