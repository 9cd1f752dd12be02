# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A body that exchanges heat, T' = (surroundings - T) / 1 s: a function of time, state and inputs, handed to SciPy."""

import tandem
from tandem.ode import Ode


def rate(t, state, inputs):
    return [inputs[0] - state[0]]


PARAMETERS = [tandem.Parameter("h", "s", "own step", 0.1)]


def make(values):
    info = tandem.Info("heat", [tandem.Port("surroundings", "K")], [tandem.Port("temperature", "K")])
    return tandem.FixedStep(Ode(info, rate, [400.0], step=values["h"], rtol=1e-9))


if __name__ == "__main__":
    tandem.serve(make, parameters=PARAMETERS)
