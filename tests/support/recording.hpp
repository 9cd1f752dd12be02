// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/coordinator/coordinator.hpp"

namespace tandem::test {

/// Keeps every row of every subsystem of a run: time, jump flag, outputs and derivatives, one row after
/// another.
class Recording final : public Observer {
 public:
  using Rows = std::vector<std::vector<double>>;

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    const auto i = static_cast<std::size_t>(subsystem);
    if (rows_.size() <= i) rows_.resize(i + 1);
    for (std::int64_t row = first; row <= last; ++row) {
      auto& entry =
          rows_[i].emplace_back(std::vector<double>{history.time(row), history.jump(row) ? 1.0 : 0.0});
      entry.insert(entry.end(), history.values(row).begin(), history.values(row).end());
    }
    return true;
  }

  const Rows& rows(int subsystem) const { return rows_[static_cast<std::size_t>(subsystem)]; }
  double time(int subsystem, std::size_t row) const { return rows(subsystem)[row][0]; }
  double value(int subsystem, std::size_t row, std::size_t output = 0) const {
    return rows(subsystem)[row][2 + output];
  }
  /// All of them, to compare two runs to the last bit.
  const std::vector<Rows>& all() const { return rows_; }

 private:
  std::vector<Rows> rows_;
};

}  // namespace tandem::test
