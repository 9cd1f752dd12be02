// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "tandem/coordinator/coordinator.hpp"

namespace tandem::engine_linkage {

/// One way to couple engine and linkage, by the words of files and tables: the bar's speed to the engine, the
/// torque to the linkage.
struct Scheme {
  std::string schedule, to_fast, to_slow;
};

/// Engine and linkage from t = 0, connected; the linkage is subsystem 0, and named slow at equal steps.
class Coupled {
 public:
  /// linkage: input `torque`, output `speed`; engine: the other way round. stop [s]. profile: efforts have
  /// seconds.
  Coupled(std::unique_ptr<Subsystem> linkage, std::unique_ptr<Subsystem> engine, const Scheme& scheme,
          double stop, bool profile = false);
  Coupled(const Coupled&) = delete;
  Coupled& operator=(const Coupled&) = delete;
  Coordinator& coordinator() { return *coordinator_; }
  long exchanges() const { return coordinator_->effort(0).exchanges + coordinator_->effort(1).exchanges; }

 private:
  std::unique_ptr<Subsystem> linkage_, engine_;
  Topology topology_;
  std::unique_ptr<Coordinator> coordinator_;
};

}  // namespace tandem::engine_linkage
