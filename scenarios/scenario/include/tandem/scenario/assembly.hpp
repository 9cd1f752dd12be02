// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "tandem/coordinator/indicators.hpp"
#include "tandem/scenario/parts.hpp"

namespace tandem::scenario {

/// A scenario made ready to run: its parts, with what coordinates them. Errors name the file and line that is
/// to blame.
class Assembly {
 public:
  /// `scenario` must outlive the assembly. profile, threads: see Coordination.
  Assembly(const Scenario& scenario, const Builtins& builtins, bool profile = false, int threads = 1);
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  const Topology& topology() const { return parts_.topology(); }
  Subsystem& subsystem(int instance) const { return *parts_.subsystem(instance); }
  Coordinator& coordinator() { return *coordinator_; }
  const Coordinator& coordinator() const { return *coordinator_; }

  /// The recorder that the scenario asks for, writing into `directory`; begin: see Recording.
  std::unique_ptr<Recorder> recorder(const std::filesystem::path& directory,
                                     std::function<void()> begin = {}) const;
  /// The indicators that the scenario asks for; null: none.
  std::unique_ptr<Indicators> indicators() const;
  /// Coordinator::initialize.
  void initialize();
  /// The coordinator's, what the subsystems remark at the start, and an impulse surrogate at any time.
  std::vector<std::string> notes() const;

 private:
  void add_positions(std::vector<std::string>& ports) const;
  std::vector<int> off_by_intent() const;

  const Scenario& scenario_;
  Parts parts_;
  std::unique_ptr<Coordinator> coordinator_;
  std::vector<std::string> of_parts_;  ///< notes
};

/// A sentence about a subsystem that lives elsewhere, with its address if that is not in it yet.
std::string with_address(const Scenario& scenario, const Builtins& builtins, std::string sentence);

}  // namespace tandem::scenario
