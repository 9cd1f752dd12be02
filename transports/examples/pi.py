# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A PI controller that samples, in Python, to be served or to be started by spawn:.

  at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y

Input y [m]; output u [N], which holds. Parameters, each of them needed: kp [N/m], ki [N/(m s)], r [m], T [s],
the offset of the first instant [s], and the latency [s], by which u changes later than the instant."""

import tandem

NAMES = ("kp", "ki", "r", "T", "offset", "latency")


class Pi:
    def __init__(self, parameters):
        if set(parameters) != set(NAMES):
            raise tandem.Error(f"pi: the parameters {', '.join(NAMES)} are needed; there are {sorted(parameters)}")
        self.kp, self.ki, self.r, self.T, self._offset, self._latency = (float(parameters[p]) for p in NAMES)

    def info(self):
        return tandem.Info("pi", [tandem.Port("y", "m")], [tandem.Port("u", "N")], feedthrough=[(0, 0)])

    def own_step(self):
        return self.T

    def offset(self):
        return self._offset

    def latency(self):
        return self._latency

    def start(self, t, u0):
        self.s = 0.0

    def outputs(self, y=None):
        """Before the first instant s alone."""
        return [self.s] if y is None else [self.kp * (self.r - y[0]) + self.s]

    def step(self, begin, end, h, y):
        self.s += self.ki * self.T * (self.r - y[0].value(begin))

    def state(self):
        return [self.s]

    def set_state(self, numbers):
        (self.s,) = numbers


if __name__ == "__main__":
    tandem.serve(lambda parameters: tandem.Sampled(Pi(parameters)))
