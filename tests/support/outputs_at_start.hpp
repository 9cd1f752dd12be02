// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {

/// Of a mechanism's file, where it starts.
inline Eigen::VectorXd outputs(const std::string& text) {
  Mechanism m(read_mechanism("m", text));
  State s = initial_state(m, 0.0);
  Index3(m, {}).start(s);
  Eigen::VectorXd y(static_cast<Eigen::Index>(m.description().outputs.size()));
  Outputs(m).evaluate(s, y.data());
  return y;
}

}  // namespace tandem::mbs
