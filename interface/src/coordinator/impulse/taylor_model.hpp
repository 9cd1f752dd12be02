// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "quadratic_map.hpp"
#include "tandem/slow_model.hpp"

namespace tandem {

/// The accelerations of a slow side by Taylor polynomials about a node: of its own ones in coordinates and velocities, and of
/// what its links' forces do in coordinates.
class TaylorModel {
 public:
  /// slow_step [s]: takes changes of coordinates to those of velocities.
  TaylorModel(std::shared_ptr<SlowModel> of, double slow_step);

  /// About coordinates q and velocities u, at time t.
  void expand(double t, std::span<const double> q, std::span<const double> u);
  /// Where they are z and v, with these forces on the links.
  void accelerations(std::span<const double> z, std::span<const double> v, std::span<const double> forces,
                     std::span<double> a) const;
  /// What generalised forces accelerate in the mean of q and the node.
  void answer(std::span<const double> q, std::span<const double> forces, std::span<double> a);
  /// The generalised forces that accelerate so in the mean of q and the node.
  void forces_for(std::span<const double> q, std::span<const double> a, std::span<double> forces);

  void write(ByteWriter& to) const {
    to.put_doubles(node_), own_.write(to), pushed_.write(to), of_->write(to);
  }
  void read(ByteReader& from) {
    for (double& one : node_) one = from.take<double>();
    own_.read(from), pushed_.read(from), of_->read(from);
  }

 private:
  std::shared_ptr<SlowModel> of_;
  std::size_t n_, p_;
  QuadraticMap own_, pushed_;
  std::vector<double> node_, steps_;           ///< q, then u
  mutable std::vector<double> off_, columns_;  ///< scratch: changes from the node; n numbers by link
  std::vector<double> pushes_, one_, other_, wanted_;
};

}  // namespace tandem
