# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Mass 2 of the two-mass test in Python, to be served or to be started by spawn:.

  m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.

Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one. Parameters: m [kg], k, s [N/m], x, v (at
the start) and h [s], each of them needed."""

import tandem


class Mass2:
    def __init__(self, parameters):
        if set(parameters) != set("mksxvh"):
            raise tandem.Error(f"mass2: the parameters m, k, s, x, v, h are needed; there are {sorted(parameters)}")
        self.m, self.k, self.s, self.x_start, self.v_start, self.h = (float(parameters[p]) for p in "mksxvh")

    def info(self):
        return tandem.Info("mass2", [tandem.Port("x1", "m")],
                           [tandem.Port("x2", "m", derivatives=2), tandem.Port("v2", "m/s", derivatives=1)])

    def own_step(self):
        return self.h

    def start(self, t, u0):
        self.x, self.v = self.x_start, self.v_start
        self.a = (self.k * u0[0] - self.s * self.x) / self.m

    def step(self, begin, end, h, u):
        before = (self.k * u[0].value(begin) - self.s * self.x) / self.m
        push = self.k * u[0].value(end)
        self.x = ((self.x + h * self.v + 0.25 * h * h * (before + push / self.m)) /
                  (1.0 + 0.25 * h * h * self.s / self.m))
        self.a = (push - self.s * self.x) / self.m
        self.v += 0.5 * h * (before + self.a)

    def outputs(self):
        return [self.x, self.v, self.v, self.a, self.a, 0.0]

    def state(self):
        return [self.x, self.v, self.a]

    def set_state(self, numbers):
        self.x, self.v, self.a = numbers


if __name__ == "__main__":
    tandem.serve(lambda parameters: tandem.FixedStep(Mass2(parameters)))
