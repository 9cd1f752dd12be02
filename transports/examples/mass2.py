# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Mass 2 of the two-mass test in Python, to be served or to be started by spawn:.

  m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.

Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one."""

import tandem


class Mass2:
    parameters = [tandem.Parameter("m", "kg", "mass"),
                  tandem.Parameter("k", "N/m", "stiffness of the spring to mass 1"),
                  tandem.Parameter("s", "N/m", "stiffness of both springs together"),
                  tandem.Parameter("x", "m", "position at the start"),
                  tandem.Parameter("v", "m/s", "speed at the start"),
                  tandem.Parameter("h", "s", "own step")]

    def __init__(self, m, k, s, x, v, h):
        self.m, self.k, self.s, self.x_start, self.v_start, self.h = m, k, s, x, v, h

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
    tandem.serve(lambda values: tandem.FixedStep(Mass2(**values)), parameters=Mass2.parameters)
