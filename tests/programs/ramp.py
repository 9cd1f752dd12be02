# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A ramp, x = t with steps of 0.1 s, as a server in Python."""

import tandem


class Ramp:
    def info(self):
        return tandem.Info("ramp", [tandem.Port("u", "m", start=0.0)], [tandem.Port("x", "m")])

    def own_step(self):
        return 0.1

    def start(self, t, u0):
        self.t = t

    def step(self, begin, end, h, u):
        self.t = end

    def outputs(self):
        return [self.t]

    def state(self):
        return [self.t]

    def set_state(self, numbers):
        (self.t,) = numbers


def make(parameters):
    if parameters:
        raise tandem.Error(f"the ramp has no parameter; there are {', '.join(parameters)}")
    return tandem.FixedStep(Ramp())


if __name__ == "__main__":
    tandem.serve(make)
