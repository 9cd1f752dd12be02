# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Python as the master: drives a subsystem of tandem, and the same model in Python beside it; the samples have to be the
same to the last bit.

  master.py tcp://HOST:PORT m=...&k=...   (served: builtin:two_mass.slow)"""

import sys

import tandem
from mass2 import Mass2


def drive(subsystem, here):
    """Ten calls with a parabola as the input."""
    clock, rows = subsystem.initialize(0.0, 100.0, [0.5])
    mine = []
    here.initialize(0.0, 100.0, [0.5], mine, 1)
    for k in range(1, 11):
        t = 1.7 * k
        u = [tandem.Signal([tandem.Segment(t, t - 1.0, (0.5, 0.1 * k, -0.02))])]
        state = subsystem.save_state()
        subsystem.advance(t, u, land=True)
        again = subsystem.deserialize_state(subsystem.serialize_state(state))
        subsystem.release_state(state)
        subsystem.restore_state(again)
        subsystem.release_state(again)
        clock, more = subsystem.advance(t, u, land=True)
        rows += more
        here.advance(t, True, u, mine, len(mine) + 1000)
        assert clock.time == t, clock
    return [(r.time, list(r.values)) for r in rows], [(r.time, list(r.values)) for r in mine]


def main(address, parameters):
    pairs = (pair.split("=") for pair in parameters.split("&"))
    model = Mass2(**{name: float(value) for name, value in pairs})
    with tandem.connect(address) as subsystem:
        print(subsystem.info())
        theirs, mine = drive(subsystem, tandem.FixedStep(model))
    assert theirs == mine, "the samples differ"
    print(len(mine), "samples, the same to the last bit")


if __name__ == "__main__":
    main(*sys.argv[1:])
