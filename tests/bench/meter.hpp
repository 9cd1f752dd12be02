// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <atomic>

namespace tandem::bench {

/// Which share of some work is done, where its pieces are not equally long. Any thread may add.
class Meter {
 public:
  /// total: what all pieces cost together, above 0.
  explicit Meter(double total) : total_(total) {}
  void add(double cost) { done_ += cost; }
  double share() const { return std::min(1.0, done_ / total_); }

 private:
  double total_;
  std::atomic<double> done_ = 0.0;
};

}  // namespace tandem::bench
