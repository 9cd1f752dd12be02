# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A PI controller that samples, in Python, to be served or to be started by spawn:.

  at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y

Input y [m]; output u [N], which holds."""

import tandem


class Pi:
    parameters = [tandem.Parameter("kp", "N/m", "proportional gain"),
                  tandem.Parameter("ki", "N/(m s)", "integral gain"),
                  tandem.Parameter("r", "m", "what y is to be"),
                  tandem.Parameter("T", "s", "period"),
                  tandem.Parameter("offset", "s", "of the first instant"),
                  tandem.Parameter("latency", "s", "by which u changes later than the instant")]

    def __init__(self, kp, ki, r, T, offset, latency):
        self.kp, self.ki, self.r, self.T, self._offset, self._latency = kp, ki, r, T, offset, latency

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
    tandem.serve(lambda values: tandem.Sampled(Pi(**values)), parameters=Pi.parameters)
