// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "period.hpp"
#include "seeded.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/identification/linear_model.hpp"
#include "tandem/scenario/parts.hpp"
#include "tandem/stability/super_step.hpp"

namespace tandem::stability {

/// Whether it is a number of the surrogate of an impulse coupling.
bool is_of_surrogate(const Coordinate& c, const scenario::Scenario& scenario);

/// Runs of a scenario over one super-step from any states and past samples.
class Trial {
 public:
  /// Data that drive inputs stay what they are at the start. Throws as super_step() does.
  Trial(const scenario::Scenario& scenario, const Builtins& builtins);

  const Period& period() const { return period_; }
  const std::vector<Coordinate>& coordinates() const { return coordinates_; }
  /// The states at the start, and past samples that are all as the first one.
  const Eigen::VectorXd& start() const { return start_; }
  /// What z becomes over one super-step.
  Eigen::VectorXd after(const Eigen::VectorXd& z);

  const Topology& topology() const { return parts_.topology(); }
  const std::vector<Identified>& identified() const { return identified_; }
  /// It, or its surrogate.
  Subsystem& subsystem(int instance) const { return *subsystems_[static_cast<std::size_t>(instance)]; }
  double begin_time() const { return scenario_.start; }
  const std::vector<StateName>& states(int instance) const {
    return states_[static_cast<std::size_t>(instance)];
  }
  /// Its inputs at the start.
  const std::vector<double>& inputs(int instance) const {
    return inputs_[static_cast<std::size_t>(instance)];
  }
  double own_step(int instance) const { return own_steps_[static_cast<std::size_t>(instance)]; }
  /// The model that stands for a sampled one, and its first instant, after the start or at it [s].
  const identification::LinearModel& model(int instance) const { return models_.at(instance); }
  double offset(int instance) const { return models_.at(instance).offset; }

 private:
  [[noreturn]] void refuse(int instance, const std::string& what) const;
  void begin();
  void find_period();
  bool is_sampled(int instance) const { return topology().info(instance).abilities.sampled; }
  bool only_gives(int instance) const;
  void stand_still(int instance, const Coordinator& run);
  void identify(int instance);
  double identify_sampled(int instance);
  identification::LinearModel model_of(int instance);
  void put(int instance, identification::LinearModel model);
  void add_coordinates(int instance, const Coordinator& run);
  int samples_read(int instance) const;
  std::set<int> values_read(int instance) const;
  void seed(const Eigen::VectorXd& z);

  const scenario::Scenario scenario_;
  scenario::Parts parts_;
  Coordination coordination_;
  std::vector<Subsystem*> subsystems_;
  std::vector<std::unique_ptr<Subsystem>> surrogates_;
  std::vector<Identified> identified_;
  std::map<int, identification::LinearModel> models_;
  std::map<int, std::vector<double>> given_;  ///< by what only gives
  std::vector<double> own_steps_;
  std::vector<std::vector<StateName>> states_;
  std::vector<std::vector<double>> inputs_;
  Period period_;
  std::vector<Coordinate> coordinates_;
  std::vector<int> ages_;  ///< past samples of each subsystem
  Eigen::VectorXd start_;
  std::vector<std::unique_ptr<Seeded>> seeded_;
  TimeSpan span_{};
};

}  // namespace tandem::stability
