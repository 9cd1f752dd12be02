// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// Of sources that are code (Source::code), which run it when they are opened.
enum class Code { run, leave_out };

struct Surrogate;
struct Guest;

/// The subsystems of a scenario opened, and the connections between them checked. What is left out is in the
/// topology as far as it was looked at, else without ports; of its connections then the other end is looked
/// for. Errors name the file and line that is to blame.
class Parts {
 public:
  /// `scenario` must outlive the parts.
  Parts(const Scenario& scenario, const Builtins& builtins, Code code);

  const Topology& topology() const { return topology_; }
  /// Null if it was left out.
  Subsystem* subsystem(int instance) const { return subsystems_[static_cast<std::size_t>(instance)].get(); }
  /// What was seen of one that was left out; null: nothing.
  const Look* look(int instance) const {
    const auto& look = looks_[static_cast<std::size_t>(instance)];
    return look ? &*look : nullptr;
  }
  /// A sentence with its place for each that was left out.
  const std::vector<std::string>& left_out() const { return left_out_; }
  /// Whether the surrogates of an impulse coupling are parts of the fast sides: they are no instances.
  bool reactive() const { return reactive_; }
  /// That of the scenario, for these instances.
  Coordination coordination() const;

  /// What a run checks beyond that of each subsystem alone: recorded outputs, and its start with what is
  /// known of its inputs.
  void check_each() const;
  /// A remark of a subsystem with its name, or that of the surrogate which is a part of it.
  std::string note_of(int instance, const std::string& remark) const;
  /// After a start: what the subsystems remark (Subsystem::remarks), and connections with one unit only.
  std::vector<std::string> notes() const;

  /// One subsystem alone. animate: it tells where its points are, if it can.
  static std::unique_ptr<Subsystem> opened(const SubsystemEntry& entry, const Builtins& builtins,
                                           bool animate = false);

 private:
  using Connections = std::vector<ConnectionEntry>;
  void open_sides(const Builtins& builtins, Code code);
  void keep(std::unique_ptr<Subsystem> subsystem, std::optional<Look> look);
  void put_instances();
  void put_instance(std::size_t instance);
  void put_connections(const Connections& all);
  void couple(Connections& connections, bool stand_ins);
  Surrogate made(const SubsystemEntry& entry, Connections& connections);
  bool can_be_reactive(const std::vector<Surrogate>& made, bool stand_ins);
  void put_guests(const std::vector<Guest>& guests, Connections& connections);
  std::optional<Look> leave_out(const SubsystemEntry& entry, const Builtins& builtins);
  const SubsystemInfo& info(std::size_t instance) const;
  bool is_left_out(const std::string& port) const;
  bool is_of_surrogate(const Line& line) const;
  void add_notes_of_units(std::vector<std::string>& notes) const;
  void add_notes_of_degrees(std::vector<std::string>& notes) const;
  void check_animation(const Builtins& builtins) const;
  void set_inputs();
  void connect(const ConnectionEntry& entry);
  void check_output(const Place& place, const std::string& what, const std::string& name) const;

  const Scenario& scenario_;
  std::vector<std::unique_ptr<Subsystem>> subsystems_;
  std::deque<std::optional<Look>> looks_;  ///< of what was left out
  SubsystemInfo no_ports_;                 ///< of that where nothing was seen
  Topology topology_;
  std::vector<std::string> left_out_, couplings_;
  bool reactive_ = false;
};

/// Whether its source itself has a parameter of this name, besides those of the model.
bool takes(const SubsystemEntry& entry, const Builtins& builtins, const std::string& word);

/// Whether a source of it is code.
bool names_code(const Scenario& scenario, const Builtins& builtins);

/// The name of a subsystem that may be in this process once, so that two such scenarios can't run in it at the
/// same time; empty: there is none.
std::string once_per_process(const Scenario& scenario, const Builtins& builtins);

}  // namespace tandem::scenario
