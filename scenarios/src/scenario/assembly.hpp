// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// A scenario made ready to run: subsystems opened, connections checked. Errors name the file and line that
/// is to blame.
class Assembly {
 public:
  /// `scenario` must outlive the assembly. profile: see Coordination.
  Assembly(const Scenario& scenario, const Builtins& builtins, bool profile = false);
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  const Topology& topology() const { return topology_; }
  Subsystem& subsystem(int instance) const { return *subsystems_[static_cast<std::size_t>(instance)]; }
  Coordinator& coordinator() { return *coordinator_; }
  const Coordinator& coordinator() const { return *coordinator_; }

  /// The recorder that the scenario asks for, writing into `directory`.
  std::unique_ptr<Recorder> recorder(const std::filesystem::path& directory) const;
  /// Coordinator::initialize.
  void initialize();
  /// The coordinator's, and equations of mechanisms that are redundant where they started.
  std::vector<std::string> notes() const;

  /// One subsystem alone; throws Error that names the place of what is to blame.
  static std::unique_ptr<Subsystem> opened(const SubsystemEntry& entry, const Builtins& builtins);

 private:
  void check_judge() const;
  void check_plots() const;
  void add_positions(std::vector<std::string>& ports) const;
  std::vector<std::string> outputs() const;

  const Scenario& scenario_;
  std::vector<std::unique_ptr<Subsystem>> subsystems_;
  Topology topology_;
  std::unique_ptr<Coordinator> coordinator_;
  std::vector<std::string> redundant_;
};

/// A sentence about a subsystem that lives elsewhere, with its address if that is not in it yet.
std::string with_address(const Scenario& scenario, const Builtins& builtins, std::string sentence);

/// What `validate` tells of a run that is initialized, beyond its notes: a force that depends on the
/// partner's state at once belongs to the follower.
std::vector<std::string> advice(const Coordinator& run);

}  // namespace tandem::scenario
