// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/push.hpp"

#include <Eigen/Geometry>

namespace tandem::mbs {

using Eigen::VectorXd;

VectorXd push_of(const Mechanism& mechanism, int input, const VectorXd& q) {
  const Description& in = mechanism.description();
  VectorXd b = VectorXd::Zero(q.size());
  for (const Force& f : in.forces) {
    if (f.input != input) continue;
    const int d = in.dimension;
    if (f.kind == Force::Kind::relative) {
      b[mechanism.numbering().relative[static_cast<std::size_t>(f.index)]] += f.gain;
    } else if (f.kind == Force::Kind::point) {
      b.segment(mechanism.coordinate(f.index), d) += f.gain * f.direction.head(d);
    } else {
      const int from = mechanism.coordinate(f.points.from), to = mechanism.coordinate(f.points.to);
      const VectorXd apart = f.gain * (q.segment(to, d) - q.segment(from, d)).normalized();
      b.segment(from, d) -= apart, b.segment(to, d) += apart;
    }
  }
  return b.head(mechanism.structure().variables);
}

}  // namespace tandem::mbs
