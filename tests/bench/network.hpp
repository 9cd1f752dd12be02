// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"

namespace tandem::bench {

/// Many subsystems that cost next to nothing, or a number of operations a call, and what links them.
///
/// pairs: 2k and 2k + 1 read each other; ring: each reads the one before it; hub: 0 and each other one read
/// each other; sampled: 3k, which is slow, and 3k + 1, which is fast, read each other, and so do 3k + 1 and
/// 3k + 2, a controller.
class Network {
 public:
  struct Setting {
    std::string topology, schedule;
    int count;
    long operations = 0;  ///< of each call
    int threads = 1;
    std::string name() const;
  };
  explicit Network(const Setting& setting);
  void round() { run_->round(); }
  /// Calls so far.
  double turns() const;

 private:
  void add(int i, int sources);
  void add_fast(int i);
  void connect(int source, int reader, int place);

  Setting setting_;
  std::vector<std::unique_ptr<Subsystem>> partners_;
  Topology topology_;
  std::optional<Coordinator> run_;
};

}  // namespace tandem::bench
