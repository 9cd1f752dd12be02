# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""sampler.py URI: drives a sampled subsystem of one input and one output, and prints what it is and gives in full."""

import sys

import tandem

with tandem.connect(sys.argv[1]) as s:
    info = s.info()
    print(info.period, info.latency, int(info.outputs[0].held))
    clock, _ = s.initialize(0.0, 10.0, [0.0])
    for k in range(1, 7):
        t, u = clock.next_time, [0.1 * k]
        _, first = s.sample(t, tandem.Part.OUTPUTS, u)
        if k % 2:
            clock, y = s.sample(t, tandem.Part.OUTPUTS | tandem.Part.STATES, u)
            assert y == first
        else:
            clock, y = s.sample(t, tandem.Part.STATES, u)
            assert not y
        print(repr(t), repr(clock.next_time), repr(first[0]))
