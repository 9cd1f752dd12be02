// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "metrics/all.hpp"

#include "metrics/two_mass.hpp"

namespace tandem {

study::CodedMetrics all_metrics() {
  study::CodedMetrics all;
  two_mass::add_metrics(all);
  return all;
}

}  // namespace tandem
