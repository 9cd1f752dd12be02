// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/trace.hpp"

#include <algorithm>

#include "output/on_grid.hpp"

namespace tandem::kart {
namespace {

int column(const SubsystemInfo& info, const Traced& quantity) {
  const auto& all = info.outputs;
  const auto it = std::find_if(all.begin(), all.end(), [&](const Port& p) {
    return p.name == quantity.outputs[0] || p.name == quantity.outputs[1];
  });
  return it == all.end() ? -1 : static_cast<int>(it - all.begin());
}

}  // namespace

Trace::Trace(const SubsystemInfo& kart, const SubsystemInfo& engine) {
  for (std::size_t k = 0; k < size; ++k) columns_[k] = column(traced[k].side == 0 ? kart : engine, traced[k]);
}

void Trace::add(int side, const History& history, std::int64_t row) {
  if (!on_grid(history, row, step)) return;
  const auto values = history.values(row);
  for (std::size_t k = 0; k < size; ++k)
    if (traced[k].side == side && columns_[k] >= 0)
      values_[k].push_back(traced[k].factor * values[static_cast<std::size_t>(columns_[k])]);
}

}  // namespace tandem::kart
