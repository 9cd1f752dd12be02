# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The speed controller as one that integrates itself with own steps of T, which it does not: to see what comes of it."""

import tandem
from controller import Controller


class OfSteps(Controller):
    def start(self, t, u0):
        super().start(t, u0)
        self.w = u0[0]

    def outputs(self):
        return super().outputs([self.w])

    def step(self, begin, end, h, u):
        super().step(begin, end, h, u)
        self.w = u[0].value(end)


tandem.serve(lambda values: tandem.FixedStep(OfSteps(**values)), parameters=OfSteps.parameters)
