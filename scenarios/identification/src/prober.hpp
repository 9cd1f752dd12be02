// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

#include "probe.hpp"

namespace tandem::identification {

/// What a run and its changes are, from the start on.
struct Runs {
  Eigen::MatrixXd baseline;
  std::vector<Eigen::MatrixXd> changes;  ///< by input, then by place; the last place is the start
  bool linear, sampled;
  /// The same, as they are up to so many steps.
  Runs up_to(std::int64_t steps) const;
  /// What an input changes at once.
  const Eigen::MatrixXd& at_once(Eigen::Index input) const {
    return changes[static_cast<std::size_t>(input * (all_places + 1) + (sampled ? 0 : all_places))];
  }
};

/// Makes them. Where the subsystem is linear changes are large, else small.
class Prober {
 public:
  /// Throws as identify() does. Both must outlive it.
  Prober(Subsystem& subsystem, const Wanted& wanted);

  Probe& probe() { return probe_; }
  const Wanted& wanted() const { return wanted_; }
  bool is_linear() const { return is_linear_; }
  /// Twice as many own steps as are wanted, up to most_steps.
  const Eigen::MatrixXd& baseline() const { return baseline_; }
  /// Where it is linear: what a change of `size(input)` makes of it that lasts the first own step.
  const Eigen::MatrixXd& moved(int input) const { return moved_[static_cast<std::size_t>(input)]; }
  double size(int input) const;
  /// Of what is linear as large as what the run itself does, so that they are known to as many digits; if it is linear then,
  /// too.
  void make_responses_large();
  /// Large ones.
  Runs runs(std::int64_t steps);

 private:
  Eigen::MatrixXd response(int input, int place, std::int64_t steps, const Eigen::MatrixXd& baseline);
  bool looks_linear();
  bool looks_linear_by_more();

  Probe probe_;
  const Wanted& wanted_;
  const std::int64_t look_;  ///< so many own steps are looked at for whether it is linear
  const Eigen::MatrixXd baseline_;
  std::vector<double> sizes_;  ///< of changes, by input
  std::vector<Eigen::MatrixXd> moved_;
  bool is_linear_ = true, are_large_ = false, is_nearly_linear_ = false;
};

}  // namespace tandem::identification
