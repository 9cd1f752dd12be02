// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <set>
#include <vector>

#include "period.hpp"
#include "seeded.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/scenario/parts.hpp"
#include "tandem/stability/super_step.hpp"

namespace tandem::stability {

/// Runs of a scenario over one super-step from any states and past samples.
class Trial {
 public:
  /// Throws as super_step() does. `scenario` must outlive it.
  Trial(const scenario::Scenario& scenario, const Builtins& builtins);

  const Period& period() const { return period_; }
  const std::vector<Coordinate>& coordinates() const { return coordinates_; }
  /// The states at the start, and past samples that are all as the first one.
  const Eigen::VectorXd& start() const { return start_; }
  /// What z becomes over one super-step.
  Eigen::VectorXd after(const Eigen::VectorXd& z);

  const Topology& topology() const { return parts_.topology(); }
  Subsystem& subsystem(int instance) const { return *parts_.subsystem(instance); }
  double begin_time() const { return scenario_.start; }
  double own_step(int instance) const { return own_steps_[static_cast<std::size_t>(instance)]; }

 private:
  void refuse(int instance, const std::string& what) const;
  void begin();
  void add_coordinates(int instance, const Coordinator& run);
  int samples_read(int instance) const;
  std::set<int> values_read(int instance) const;
  void seed(const Eigen::VectorXd& z);

  const scenario::Scenario& scenario_;
  scenario::Parts parts_;
  Coordination coordination_;
  std::vector<double> own_steps_;
  Period period_;
  std::vector<Coordinate> coordinates_;
  std::vector<int> ages_;  ///< past samples of each subsystem
  Eigen::VectorXd start_;
  std::vector<std::unique_ptr<Seeded>> seeded_;
  TimeSpan span_{};
};

}  // namespace tandem::stability
