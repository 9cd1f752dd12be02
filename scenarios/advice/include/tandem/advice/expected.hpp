// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "tandem/scenario/run.hpp"

namespace tandem::advice {

/// What linear models of the subsystems say of the judged output over time, for Indication::estimate. They run
/// fastest-first with cubic reconstructions. Each own step is a sixteenth, and no longer than the shortest of the scenario.
/// Second instances of the subsystems are opened to find the models. Sampled ones run themselves. Where another one has no
/// model it says so.
/// - scenario: it has a [judge].
/// - going: false: it ends, with nothing.
scenario::Expectation expected(const scenario::Scenario& scenario, const Builtins& builtins,
                               const std::function<bool()>& going = {});

}  // namespace tandem::advice
