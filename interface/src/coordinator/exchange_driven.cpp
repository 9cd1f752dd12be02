// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that no other subsystem gives: constant, known beforehand, or open.
#include <algorithm>
#include <cassert>

#include "tandem/coordinator/exchange.hpp"

namespace tandem {

/// Inputs without a connection keep their start value.
void Exchange::hold_start_values(const Topology& topology, int i) {
  End& reader = ends_[static_cast<std::size_t>(i)];
  const auto& start = topology.start(i);
  reader.constants.resize(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) {
    reader.constants[k].c[0] = start[k];
    reader.slots[k] = Signal(&reader.constants[k], 1, 0);
  }
  if (topology.info(i).abilities.sampled) reader.values = start;
  if (topology.info(i).abilities.sampled) reader.values.resize(reader.slots.size());
}

void Exchange::drive(const Topology& topology, int i, double t_start) {
  End& reader = ends_[static_cast<std::size_t>(i)];
  for (std::size_t k = 0; k < static_cast<std::size_t>(reader.inputs); ++k)
    if (const TimeSeries* series = topology.series(i, static_cast<int>(k)))
      reader.driven.emplace_back(*series, k, tolerance_, t_start), reader.has_more = true;
    else if (topology.is_open(i, static_cast<int>(k)))
      reader.driven.emplace_back(topology.start(i)[k], k, tolerance_, topology.info(i).abilities.sampled),
          reader.has_more = true;
}

Driven& Exchange::open_input(int reader, int input) {
  auto& all = ends_[static_cast<std::size_t>(reader)].driven;
  const auto it = std::find_if(all.begin(), all.end(), [input](const Driven& one) {
    return one.is_open() && one.slot() == static_cast<std::size_t>(input);
  });
  assert(it != all.end());
  return *it;
}

void Exchange::forget_jumps(int reader) {
  for (Driven& one : ends_[static_cast<std::size_t>(reader)].driven)
    if (one.is_open()) one.forget_jump();
}

}  // namespace tandem
