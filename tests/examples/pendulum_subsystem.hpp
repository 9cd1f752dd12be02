// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>

#include "pendulum.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace example {

/// The pendulum with an own step. Input: the force [N]. Outputs: x, y [m], which do not follow it at once.
class PendulumSubsystem final : public tandem::Subsystem {
 public:
  explicit PendulumSubsystem(double step)
      : info_{"pendulum", {{"push", "N"}}, {{"x", "m"}, {"y", "m"}}, {}, {.restarts = true}},
        stepper_(tandem::mbs::make_stepper(pendulum_, {})),
        step_(step) {}

  const tandem::SubsystemInfo& info() const override { return info_; }

  tandem::Clock initialize(double t, double, std::span<const double> u0, tandem::Samples& y) override {
    grid_ = tandem::TimeGrid(t, step_);
    pendulum_.signal = nullptr;
    pendulum_.push = std::isnan(u0[0]) ? 0.0 : u0[0];
    state_ = Pendulum::level(t);
    stepper_->start(state_);
    append(y);
    return {t, grid_.next(), tandem::Stop::limit};
  }

  tandem::Clock advance(double t_limit, bool, std::span<const tandem::Signal> u,
                        tandem::Samples& y) override {
    pendulum_.signal = &u[0];
    for (; !y.full() && grid_.fits(t_limit); append(y)) {
      const double before = pendulum_.push;
      pendulum_.at_time(grid_.time());
      if (pendulum_.push != before) stepper_->refresh(state_);  // it has jumped
      stepper_->step(state_, grid_.h(), grid_.next());
      grid_.step();
    }
    const bool more = grid_.fits(t_limit);
    return {grid_.time(), grid_.next(), more ? tandem::Stop::samples_full : tandem::Stop::limit};
  }

  const tandem::mbs::State& state() const { return state_; }

 private:
  void append(tandem::Samples& y) const { std::copy_n(state_.q.data(), 2, y.append(grid_.time())); }

  tandem::SubsystemInfo info_;
  Pendulum pendulum_;
  std::unique_ptr<tandem::mbs::Stepper> stepper_;
  double step_;
  tandem::TimeGrid grid_;
  tandem::mbs::State state_;
};

}  // namespace example
