// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

#include "courses.hpp"
#include "tandem/identification/identify.hpp"

namespace tandem::identification {

/// How one input differs in a run.
struct Change {
  int input;
  int place;  ///< at which it is `size` in the first step; all_places: at the start alone; throughout: all over it
  double size;  ///< in the unit of the input
};
constexpr int all_places = static_cast<int>(places.size()), throughout = all_places + 1;

/// States and wanted values at the start, and after an own step.
struct OneStep {
  Eigen::VectorXd x0, y0, x1, y1;
};

/// Runs of a subsystem alone.
class Probe {
 public:
  /// Throws as identify() does. Both must outlive it.
  Probe(Subsystem& subsystem, const Wanted& wanted);

  double step() const { return step_; }
  bool is_sampled() const { return subsystem_.info().abilities.sampled; }
  /// Of one that is sampled: its first instant after the start [s], and its values until then.
  double offset() const { return offset_; }
  const Eigen::VectorXd& before() const { return before_; }
  int inputs() const { return static_cast<int>(wanted_.inputs.size()); }
  /// The wanted values, a column each for the start and so many own steps; of one that is sampled for its first instants.
  Eigen::MatrixXd run(std::int64_t steps, const Change* change = nullptr);
  /// How many states it tells; -1: it keeps them to itself.
  Eigen::Index states();
  /// by: what its states are moved by at the start.
  OneStep one_step(const Change* change, const Eigen::VectorXd& by);

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  Samples start(std::int64_t rows, const Change* change);
  void advance(double until, const Change* change, Samples& y);
  Eigen::MatrixXd instants(std::int64_t count, const Change* change);
  Eigen::VectorXd wanted_of(std::span<const double> row) const;

  Subsystem& subsystem_;
  const Wanted& wanted_;
  double step_ = 0.0, offset_ = 0.0;
  Eigen::VectorXd before_;
  std::vector<double> memory_;
  Courses courses_;
};

}  // namespace tandem::identification
