// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <vector>

#include "tandem/coordinator/coordination.hpp"
#include "tandem/coordinator/topology.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::scenario {

/// Outputs of a run in memory, each at the own steps of its subsystem. A held output is a step at each of
/// them: two rows of one time, as at a jump.
class Traces final : public Observer {
 public:
  /// outputs: "instance.port" or "instance.port[i]". name: what errors call the run. Throws Error for one
  /// that is not there.
  Traces(const Topology& topology, const std::vector<std::string>& outputs, const std::string& name);

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override;

  /// One of the outputs: a column with its name, and where it gives derivatives or is held a column
  /// der(NAME).
  const text::TimeTable& of(const std::string& output) const { return traces_.at(output).table; }
  const std::string& unit(const std::string& output) const { return traces_.at(output).unit; }

 private:
  struct Trace {
    int output = 0;  ///< flattened
    bool held = false, has_slope = false;
    std::string unit;
    text::TimeTable table;

    void add(double t, double value, double slope);
  };

  std::map<std::string, Trace> traces_;
  std::vector<std::vector<Trace*>> by_subsystem_;
};

}  // namespace tandem::scenario
