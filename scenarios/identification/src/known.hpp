// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "tandem/identification/linear_model.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::identification {

/// What a subsystem that starts says.
struct Beginning {
  Clock clock;
  std::vector<double> row;
};

/// Subsystems that differ by their own steps alone. Whether they go by their own clock is seen once.
struct Kin {
  std::once_flag seen;
  std::optional<double> apart;  ///< when [s]
};

/// What is known of the subsystems of one source with the same parameters. Any thread may call it.
class Known {
 public:
  using Opened = std::function<Subsystem&()>;
  Known(const std::string& source, std::shared_ptr<Kin> kin) : kin_(std::move(kin)) {
    stand_.source = source;
  }

  /// The first time by one that is opened; then no other needs to be.
  void see(const Subsystem& one);
  bool is_seen() const;
  /// Once it is seen. It becomes its model, if it has one.
  bool may_have_model() const { return may_have_model_; }
  const SubsystemInfo& info() const { return *info_; }
  bool one_thread() const { return one_thread_; }

  Beginning beginning(const TimeSpan& span, std::span<const double> u0, const Opened& real);
  /// Found the first time.
  void find(const TimeSpan& span, std::span<const double> u0, const Clock& clock, const Opened& real);
  /// Of a step [s]; 0: its own. Null: it has none.
  const LinearModel* model(double step);
  const Stand& stand() const { return stand_; }

 private:
  void look(Subsystem& real, const TimeSpan& span, std::span<const double> u0, const Clock& clock);
  void keep(Subsystem& real, LinearModel found, const TimeSpan& span, std::span<const double> u0);

  mutable std::mutex mutex_;
  std::once_flag found_;
  std::shared_ptr<Kin> kin_;
  std::optional<SubsystemInfo> info_;
  bool one_thread_ = false, may_have_model_ = false;
  Stand stand_;
  std::map<std::vector<std::uint64_t>, Beginning> beginnings_;  ///< by the bits of the span and the inputs
  std::map<double, std::optional<LinearModel>> models_;         ///< by step
};

}  // namespace tandem::identification
