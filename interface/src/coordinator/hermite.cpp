// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "link_rows.hpp"

namespace tandem {
namespace {

/// The cubic p(s) = y + y' s + c2 s^2 + c3 s^3 with p and p' given at s = 0 and s = -h, the ends of the
/// source's step; of a first sample (h = 0), its tangent.
struct Cubic {
  std::int64_t stride;
  int outputs;

  double prepare(const double* row, std::int64_t fitted) const {
    return fitted > 0 ? row[0] - row[-stride] : 0.0;
  }

  void fill(double h, const double* row, const Lane& lane, double* before, double* c) const {
    const double y = lane.gain * row[Samples::header + lane.output] + lane.offset;
    const double slope = lane.gain * row[Samples::header + outputs + lane.output];
    c[0] = y;
    c[1] = slope;
    c[2] = c[3] = 0.0;
    if (h > 0.0) {
      const double chord = (y - before[0]) / h;
      c[3] = (slope + before[1] - 2.0 * chord) / (h * h);
      c[2] = (2.0 * slope + before[1] - 3.0 * chord) / h;
    }
    before[0] = y;
    before[1] = slope;
  }
};

}  // namespace

void Link::extend_hermite(Link& link, NewRows rows) {
  const Cubic cubic{link.stride_, link.samples_->outputs()};
  link.extend_rows(rows, cubic, cubic);
}

}  // namespace tandem
