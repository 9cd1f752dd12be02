// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::test {

/// A double pendulum with two force inputs, the drag of air and an output of each kind.
inline const std::string pushed_pendulum = R"(
dimension = 2
gravity = [0, -9.81]
[points]
O = { at = [0, 0], fixed = true }
A = { at = [1, 0] }
B = { at = [2, 0] }
[rods]
r = { points = ["O", "A"], mass = 1 }
s = { points = ["A", "B"], mass = 1 }
[inputs]
F = { unit = "N" }
G = { unit = "N" }
[forces]
f = { point = "A", direction = [1, 2], magnitude = "F" }
g = { point = "B", direction = [0, 1], magnitude = "G" }
[elements.air]
kind = "drag"
point = "B"
coefficient = 0.1
[outputs]
x = { position = "B.x" }
v = { velocity = "B.y" }
a = { acceleration = "A.y" }
r = { reaction = "O.x" }
e = { energy = "total" }
d = { energy = "drift" }
p = { element = "air", quantity = "power" }
h = { residual = "acceleration" }
)";

}  // namespace tandem::test
