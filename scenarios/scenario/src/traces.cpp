// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/traces.hpp"

#include <algorithm>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::scenario {

Traces::Traces(const Topology& topology, const std::vector<std::string>& outputs, const std::string& name)
    : by_subsystem_(static_cast<std::size_t>(topology.size())) {
  for (int i = 0; i < topology.size(); ++i) {
    const auto names = topology.output_names(i);
    int output = 0;
    for (const Port& port : topology.info(i).outputs)
      for (int element = 0; element < port.size; ++element, ++output) {
        const std::string& scalar = names[static_cast<std::size_t>(output)];
        if (std::find(outputs.begin(), outputs.end(), scalar) == outputs.end()) continue;
        Trace trace{
            output, port.held, port.held || port.derivatives > 0, port.unit, {name, {}, {scalar}, {{}}}};
        if (trace.has_slope)
          trace.table.names.push_back("der(" + scalar + ")"), trace.table.columns.emplace_back();
        by_subsystem_[static_cast<std::size_t>(i)].push_back(&(traces_[scalar] = std::move(trace)));
      }
  }
  for (const std::string& output : outputs)
    if (!traces_.contains(output))
      throw Error(ErrorCode::invalid_argument, unknown("output", output, topology.output_names()));
}

bool Traces::samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) {
  for (Trace* trace : by_subsystem_[static_cast<std::size_t>(subsystem)])
    for (std::int64_t row = first; row <= last; ++row) {
      const double t = history.time(row), *y = history.values(row).data();
      if (trace->held) {
        if (!trace->table.times.empty()) trace->add(t, trace->table.columns[0].back(), 0.0);
        trace->add(t, y[trace->output], 0.0);
      } else {
        trace->add(t, y[trace->output], trace->has_slope ? y[history.outputs() + trace->output] : 0.0);
      }
    }
  return true;
}

void Traces::Trace::add(double t, double value, double slope) {
  table.times.push_back(t);
  table.columns[0].push_back(value);
  if (has_slope) table.columns[1].push_back(slope);
}

}  // namespace tandem::scenario
