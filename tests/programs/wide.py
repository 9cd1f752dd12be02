# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The wide subsystem of tests/libraries/wide.c in Python."""

import tandem

H = 1e-9


class Wide:
    def __init__(self, parameters):
        inputs, outputs, self.bytes = (int(parameters.get(key, 1)) for key in ("inputs", "outputs", "bytes"))
        abilities = tandem.Abilities.SAVES_STATE | tandem.Abilities.SERIALIZES_STATE | tandem.Abilities.RESTARTS
        self._info = tandem.Info("wide", [tandem.Port("u", "1", inputs)], [tandem.Port("y", "1", outputs)],
                                 abilities=abilities)
        self._values, self._saved, self._dumb = [1.0] * outputs, [], parameters.get("dumb") == "2"

    def info(self):
        return self._info

    def clock(self, stop):
        return tandem.Clock(self.time, self.time + H, stop)

    def append(self, rows):
        rows.append(tandem.Row(self.time, self._values))

    def initialize(self, t_start, t_stop, u0, rows, room):
        self.time = t_start
        self.append(rows)
        return self.clock(tandem.Stop.LIMIT)

    def advance(self, t_limit, land, u, rows, room):
        while len(rows) < room:
            self.time += H
            self.append(rows)
        return self.clock(tandem.Stop.SAMPLES_FULL)

    def save_state(self):
        self._saved.append(b"\1" * self.bytes)
        return len(self._saved) - 1

    def serialize_state(self, state):
        if self._dumb:
            raise tandem.Error("it is not so wide", 6)
        return self._saved[state]

    def release_state(self, state):
        if self._dumb and state == len(self._saved) - 1:
            self._saved.pop()

    def deserialize_state(self, data):
        return 1 << 40  # nothing of them is kept, so that what is measured is not the model's


if __name__ == "__main__":
    tandem.serve(Wide)
