// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>

#include "known.hpp"

namespace tandem::identification {

/// A subsystem that becomes its model where it starts with inputs that are known. Where the model is known it is not opened.
std::unique_ptr<Subsystem> make_stand_in(std::shared_ptr<Known> known, double step, Models::Without without,
                                         std::function<std::unique_ptr<Subsystem>()> open);
/// Throws Error unless a run may do without a model of it.
void refuse_without(const Stand& stand, Models::Without without);

}  // namespace tandem::identification
