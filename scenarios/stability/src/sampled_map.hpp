// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "true_modes.hpp"
#include "undivided.hpp"

namespace tandem::stability {

/// What a system in which something is sampled becomes over one super-step where nothing divides it: it flows by matrix
/// exponentials, held outputs being constants, and at instants what is sampled acts as a coordinator makes it act
/// (docs/sampled.md). Numbers of it are those of Undivided.
class SampledMap {
 public:
  /// Throws Error(not_supported) as undivided() does, and where the periods of what is sampled do not meet within the
  /// super-step. `trial` must outlive it.
  SampledMap(const Trial& trial, bool is_linear);

  /// Of the map's eigenvectors. By what angle each turns in all is followed through the super-step.
  TrueModes modes() const;

 private:
  /// One time at which instances change.
  struct Happening {
    double time = 0.0;                      ///< after the begin [s]
    std::vector<int> take_effect, samples;  ///< instances whose oldest outputs do, and that act
  };

  void find_happenings();
  Happening& at(double time);
  /// By numbers before it; `waiting`: outputs of each instance that are not in effect yet.
  Eigen::MatrixXd jump(const Happening& happening, std::vector<int>& waiting) const;
  Eigen::MatrixXd inputs(int instance, const Eigen::MatrixXd& before, const Eigen::MatrixXd& now) const;
  /// Told of each part of the super-step what it multiplies the numbers by, and whether something acted there.
  using Visit = std::function<void(const Eigen::MatrixXd&, bool is_instant)>;
  void pass(const Visit& by) const;
  Eigen::MatrixXd map() const;
  Eigen::VectorXd turns(Eigen::MatrixXcd vectors, const std::vector<Eigen::Index>& told_by) const;

  const Trial& trial_;
  Undivided whole_;
  double fastest_;  ///< |mu| of what flows [1/s]
  std::vector<Happening> happenings_;
  std::vector<int> waiting_;  ///< of each instance, at the begin
};

}  // namespace tandem::stability
