// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::test {

/// A mass on a spring with stops, pushed: states, events, and an output that follows the input at once.
inline const std::string pushed_mass = R"(
[parameters]
stiffness = { value = 40.0, unit = "N/m" }
[inputs]
F = { unit = "N" }
[blocks]
pull = { kind = "product", inputs = ["x", "$stiffness"] }
stop = { kind = "dead_zone", input = "x", low = -0.5, high = 0.5 }
a = { kind = "sum", inputs = ["F", "pull", "stop", "v"], gains = [1, -1, -200, -0.5] }
v = { kind = "integrator", input = "a" }
x = { kind = "integrator", input = "v", initial = 0.3 }
seen = { kind = "sample", input = "x", period = 0.07 }
side = { kind = "relay", input = "x", low = -0.1, high = 0.1 }
[outputs]
x = { unit = "m" }
v = { unit = "m/s" }
a = { unit = "m/s^2" }
seen = { unit = "m" }
side = { unit = "1" }
)";

}  // namespace tandem::test
