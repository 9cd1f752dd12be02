# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The speed controller of the drive, which samples.

  at t_start + k T:   i_ref = kp e + s,   then   s becomes s + ki T e,   e = set - w

Input w [rad/s]; output i_ref [A], which holds."""

import tandem


class Controller:
    parameters = [tandem.Parameter("kp", "A s/rad", "proportional gain"),
                  tandem.Parameter("ki", "A/rad", "integral gain"),
                  tandem.Parameter("set", "rad/s", "speed that is wanted"),
                  tandem.Parameter("T", "s", "period")]

    def __init__(self, kp, ki, set, T):
        self.kp, self.ki, self.set, self.T = kp, ki, set, T

    def info(self):
        return tandem.Info("controller", [tandem.Port("w", "rad/s")], [tandem.Port("i_ref", "A")], feedthrough=[(0, 0)])

    def own_step(self):
        return self.T

    def start(self, t, u0):
        self.s = 0.0

    def outputs(self, u=None):
        return [self.s] if u is None else [self.kp * (self.set - u[0]) + self.s]

    def step(self, begin, end, h, u):
        self.s += self.ki * self.T * (self.set - u[0].value(begin))

    def state(self):
        return [self.s]

    def set_state(self, numbers):
        (self.s,) = numbers


if __name__ == "__main__":
    tandem.serve(lambda values: tandem.Sampled(Controller(**values)), parameters=Controller.parameters)
