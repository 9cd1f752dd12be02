# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""x' = u by the trapezoidal rule with steps of 0.1 s, as a server in Python."""

import tandem


class Integral:
    def info(self):
        return tandem.Info("integral", [tandem.Port("u", "m/s", start=0.0)], [tandem.Port("x", "m")])

    def own_step(self):
        return 0.1

    def start(self, t, u0):
        self.x = 0.0

    def step(self, begin, end, h, u):
        self.x += h * (u[0].value(begin) + u[0].value(end)) / 2.0

    def outputs(self):
        return [self.x]


if __name__ == "__main__":
    tandem.serve(lambda parameters: tandem.FixedStep(Integral()))
