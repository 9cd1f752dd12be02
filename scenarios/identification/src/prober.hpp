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

  const Probe& probe() const { return probe_; }
  bool is_linear() const { return is_linear_; }
  Runs runs(std::int64_t steps);

 private:
  double size(int input) const;
  void make_responses_large();
  Eigen::MatrixXd response(int input, int place, std::int64_t steps, const Eigen::MatrixXd& baseline);
  bool looks_linear();

  Probe probe_;
  const Wanted& wanted_;
  std::vector<double> sizes_;  ///< of changes, by input
  bool is_linear_ = true;
};

}  // namespace tandem::identification
