# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""x' = u by the trapezoidal rule with steps of 0.1 s, and y = x + u, which follows u at once, as a server in Python."""

import tandem


class Follower:
    def info(self):
        return tandem.Info("follower", [tandem.Port("u", "m/s")], [tandem.Port("x", "m")], feedthrough=[(0, 0)])

    def own_step(self):
        return 0.1

    def start(self, t, u0):
        self.x, self.u = 0.0, u0[0]

    def step(self, begin, end, h, u):
        self.u = u[0].value(end)
        self.x += h * (u[0].value(begin) + self.u) / 2.0

    def jump(self, t, u):
        before, self.u = self.u, u[0].value(t)
        return self.u != before

    def outputs(self):
        return [self.x + self.u]


if __name__ == "__main__":
    tandem.serve(lambda parameters: tandem.FixedStep(Follower()))
