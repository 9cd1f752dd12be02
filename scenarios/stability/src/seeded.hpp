// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::stability {

/// A subsystem with a past of our own: up to `begin` it gives samples that it is told, then it goes on from states
/// that it is told. So a coordinator's histories and a subsystem's states are what a trial wants them to be.
class Seeded final : public Subsystem {
 public:
  /// inner: restarts and names its states; it must outlive this. step: between two samples of the past [s].
  Seeded(Subsystem& inner, double begin, double step);

  /// past: the newest samples at `begin` and before, the newest first, each as long as a row's values; older ones
  /// are 0. states: from where it goes on.
  void seed(std::vector<std::vector<double>> past, std::vector<double> states);
  /// The value of the newest sample but `age`.
  double sample(int age, int index) const;
  /// Samples up to `begin` of the run before, which tells this one which of them is the newest.
  std::int64_t before() const { return before_; }

  const SubsystemInfo& info() const override { return inner_.info(); }
  void get_states(std::span<double> x) const override { inner_.get_states(x); }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;

 private:
  void give(Samples& y);
  void enter(std::span<const Signal> u);
  Clock go_on(double t_limit, bool land, std::span<const Signal> u, Samples& y);

  Subsystem& inner_;
  double begin_, step_, stop_ = 0.0;
  std::vector<std::vector<double>> past_;
  std::vector<double> states_;
  TimeGrid grid_;
  std::int64_t given_ = 0, before_ = 0;
  bool entered_ = false;
  std::vector<std::vector<double>> newest_;  ///< rows of this run, the newest last
};

}  // namespace tandem::stability
