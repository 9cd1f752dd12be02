// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Runs that pause: they are made up to points of time that are told on the way, on inputs that are told there.
#include "tandem/coordinator/coordinator.hpp"

namespace tandem {

void Coordinator::run_to(double t) {
  stop_at(t);
  ended_ = false;
  while (make_round()) {
  }
  check_end();
  keep_rest();
}

void Coordinator::stop_at(double t) {
  schedule_->stop_at(t);
  place_all();
}

void Coordinator::tell_jumps() {
  for (const int who : followers_) {
    if (exchange_->jumps_at(who, time(who))) tell_jump(who);
    exchange_->forget_jumps(who);
  }
}

}  // namespace tandem
