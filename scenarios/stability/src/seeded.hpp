// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem::stability {

/// A subsystem with a past of our own: up to `begin` it gives samples that it is told, then it goes on from
/// states that it is told. So a coordinator's histories and a subsystem's states are what a trial wants them
/// to be.
class Seeded : public Subsystem {
 public:
  /// inner: restarts and names its states; it must outlive this. step: between two samples of the past [s].
  Seeded(Subsystem& inner, double begin, double step) : inner_(inner), begin_(begin), step_(step) {}

  /// past: the newest samples at `begin` and before, the newest first, each as long as a row's values; older
  /// ones are 0. states: from where it goes on.
  void seed(std::vector<std::vector<double>> past, std::vector<double> states);
  /// The value of the newest sample but `age`.
  double sample(int age, int index) const;

  const SubsystemInfo& info() const override { return inner_.info(); }
  void get_states(std::span<double> x) const override { inner_.get_states(x); }
  /// Whoever leads one that has events keeps where it stood. Nobody goes back there: an event ends a trial.
  StateId save_state() override { return 0; }
  void release_state(StateId) override {}

 protected:
  std::vector<double> past(std::int64_t age) const;
  Subsystem& inner() { return inner_; }
  double begin() const { return begin_; }
  double step() const { return step_; }
  const std::vector<double>& seeded_states() const { return states_; }
  std::vector<std::vector<double>> newest_;  ///< rows of this run, the newest last

 private:
  Subsystem& inner_;
  double begin_, step_;
  std::vector<std::vector<double>> past_;
  std::vector<double> states_;
};

/// One that integrates itself, or that is sampled. offset: of the latter, from `begin` to its first instant
/// there or after [s], which inner has too.
std::unique_ptr<Seeded> make_seeded(Subsystem& inner, double begin, double step, double offset);

}  // namespace tandem::stability
