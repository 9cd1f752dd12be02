// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "tandem/mbs/state_bytes.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::mbs {

/// A state and the stepper that moves it. A copy is a state that is kept: it shares the stepper and remembers
/// what that goes by besides the state.
class MovingState {
 public:
  explicit MovingState(std::shared_ptr<Stepper> stepper) : stepper_(std::move(stepper)) {}
  MovingState(const MovingState& other) { *this = other; }
  MovingState& operator=(const MovingState& other) {
    if (other.kept_)
      memory_ = other.memory_;
    else
      memory_.clear(), other.stepper_->remember(memory_);
    kept_ = true;
    stepper_ = other.stepper_;
    state_ = other.state_;
    return *this;
  }

  /// Of one that is kept. read() refuses that of another model or stepper.
  void write(ByteWriter& to) const {
    mbs::write(state_, to);
    to.put_list(memory_);
  }
  void read(ByteReader& from) {
    mbs::read(state_, from);
    memory_ = from.take_list();
  }

  const State& state() const { return state_; }
  void start(State state) {
    state_ = std::move(state);
    stepper_->start(state_);
    kept_ = false;
  }
  /// At t, which is the state's time but for rounding.
  void refresh(double t) {
    recall();
    state_.time = t;
    stepper_->refresh(state_);
  }
  void step(double length, double end) {
    recall();
    stepper_->step(state_, length, end);
  }

 private:
  void recall() {
    if (std::exchange(kept_, false)) stepper_->recall(memory_);
  }

  std::shared_ptr<Stepper> stepper_;
  State state_;
  std::vector<double> memory_;  ///< what the stepper remembers, of a state that is kept
  bool kept_ = false;
};

}  // namespace tandem::mbs
