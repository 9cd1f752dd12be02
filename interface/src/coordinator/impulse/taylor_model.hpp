// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "tandem/coordinator/impulse/quadratic_map.hpp"
#include "tandem/slow_model.hpp"

namespace tandem {

/// The accelerations of a slow side by Taylor polynomials about a node: of its own ones in coordinates and velocities, and of
/// what its links' forces do in coordinates.
class TaylorModel {
 public:
  /// slow_step [s]: takes changes of coordinates to those of velocities.
  TaylorModel(std::shared_ptr<SlowModel> of, double slow_step);

  /// About coordinates q and velocities u, at time t. What other inputs have changed of the accelerations since the node
  /// before goes on as a straight line.
  void expand(double t, std::span<const double> q, std::span<const double> u);
  /// Before the next expand(), where the slow side stands at its node: what its other inputs have changed meanwhile.
  void see_inputs(double t);
  std::span<const double> changed() const { return changed_; }
  /// Where they are z and v, with these forces on the links, s after the node.
  void accelerations(std::span<const double> z, std::span<const double> v, std::span<const double> forces,
                     double s, std::span<double> a) const;
  /// What generalised forces accelerate in the mean of q and the node.
  void answer(std::span<const double> q, std::span<const double> forces, std::span<double> a);
  /// The generalised forces that accelerate so in the mean of q and the node.
  void forces_for(std::span<const double> q, std::span<const double> a, std::span<double> forces);

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  void recall();
  void mean_answer(std::span<const double> q, std::span<const double> forces, std::span<double> a);
  std::shared_ptr<SlowModel> of_;
  std::size_t n_, p_;
  QuadraticMap own_, pushed_;
  std::vector<double> node_, steps_;           ///< q, then u
  mutable std::vector<double> off_, columns_;  ///< scratch: changes from the node; n numbers by link
  std::vector<double> rates_;                  ///< of the accelerations by time, from other inputs
  std::vector<double> changed_;
  double time_ = 0.0;  ///< of the node
  bool first_ = true;
  std::vector<std::byte>
      stands_;  ///< what the equations go by at the node; several surrogates may share them
  std::vector<double> pushes_, one_, other_, wanted_;
};

}  // namespace tandem
