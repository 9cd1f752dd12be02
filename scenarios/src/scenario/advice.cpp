// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "scenario/assembly.hpp"

namespace tandem::scenario {
namespace {

bool leads(const Schedule& schedule, int a, int b) {
  if (schedule.kind() == Schedule::Kind::parallel) return false;
  const auto order = schedule.order();
  return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
}

/// An input of `source` that `reader` feeds and that reaches `output` at once; -1 for none.
int fed_through(const Topology& topology, const Line& line) {
  for (const Feedthrough& f : topology.info(line.source).feedthrough)
    for (const Line& back : topology.lines())
      if (f.output == line.output && back.source == line.reader && back.reader == line.source &&
          back.input == f.input)
        return f.input;
  return -1;
}

}  // namespace

std::vector<std::string> advice(const Coordinator& run) {
  const Topology& topology = run.topology();
  std::vector<std::string> lines;
  for (const Line& line : topology.lines()) {
    const int input = fed_through(topology, line);
    if (input < 0 || !leads(run.schedule(), line.source, line.reader)) continue;
    const std::string leader = topology.name(line.source), follower = topology.name(line.reader);
    lines.push_back("output " + topology.output_name(line.source, line.output) +
                    " depends at once on input " + topology.input_name(line.source, input) + ", which '" +
                    leader + "' extrapolates, as it leads in schedule " +
                    std::string(Schedule::name(run.schedule().kind())) +
                    "; the error is smaller when the follower gives such an output: let '" + follower +
                    "' lead, or give the force on the other side");
  }
  return lines;
}

}  // namespace tandem::scenario
