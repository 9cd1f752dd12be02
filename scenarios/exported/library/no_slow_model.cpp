// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A mechanism in an FMU is no slow side of an impulse coupling there.
#include "slow_mechanism.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {

std::shared_ptr<SlowModel> slow_model_of(const Description&, WhereItIs, const std::vector<int>&,
                                         std::span<const SlowLink>) {
  return nullptr;
}

void take_reactions(Description&, const std::vector<std::string>&) {}

}  // namespace tandem::mbs
