// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "four_bar/linkage.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::test {

/// The linkage where all its cranks have that angle and rate.
inline mbs::State standing(mbs::Mechanism& linkage, const four_bar::Crank& crank) {
  mbs::State s = linkage.described_state();
  const int points = linkage.structure().variables / 2;
  for (int i = 0; i < points; ++i) {
    s.q.segment(2 * i, 2) << i + std::sin(crank.angle), std::cos(crank.angle);
    s.v.segment(2 * i, 2) << std::cos(crank.angle) * crank.rate, -std::sin(crank.angle) * crank.rate;
  }
  mbs::Index3(linkage, {}).start(s);
  return s;
}

}  // namespace tandem::test
