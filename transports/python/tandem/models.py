# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What makes a model a subsystem."""

from __future__ import annotations

import math
import struct
import sys
from typing import Any, Dict, List, Sequence, Tuple

from .contract import Abilities, Clock, Error, Info, Part, Row, Segment, Signal, Stop


def before(a: float, b: float, t_start: float) -> bool:
    """a lies before b by more than rounding (tandem::TimeTolerance)."""
    return a < b and a < b - 6.0 * sys.float_info.epsilon * max(max(abs(a), abs(b)), abs(t_start))


class TimeGrid:
    """Own steps of fixed length: node k is t_start + k h, multiplied and never accumulated."""

    def __init__(self, t_start: float, h: float) -> None:
        if not (math.isfinite(h) and h > 0.0):
            raise Error(f"own step {h} s; it must be finite and above 0")
        self.t_start, self.h = t_start, h
        self.time, self.next = t_start, t_start + h
        self._node, self._whole = 1, True

    def length(self) -> float:
        """Of the next own step: h, or what a cut has left of it."""
        return self.h if self._whole else self.next - self.time

    def fits(self, t_limit: float) -> bool:
        return not before(t_limit, self.next, self.t_start)

    def cuts(self, t_limit: float) -> bool:
        return not self.fits(t_limit) and before(self.time, t_limit, self.t_start)

    def step(self) -> None:
        self._node += 1
        self.time, self.next = self.next, self.t_start + self._node * self.h
        self._whole = True

    def cut(self, t: float) -> None:
        self.time, self._whole = t, False

    def steps(self) -> int:
        """Own steps that it has taken, and node(steps()) is where the last one ended."""
        return self._node - 1

    def node(self, k: int) -> float:
        return self.t_start + k * self.h

    def place(self) -> bytes:
        """Where it stands, as bytes (tandem::TimeGrid::write)."""
        return struct.pack("<dddqB", self.t_start, self.h, self.time, self._node, self._whole)

    def put(self, place: bytes) -> None:
        t_start, h, time, node, whole = struct.unpack("<dddqB", place)
        if (t_start, h) != (self.t_start, self.h):
            raise Error(f"the state is of own steps of {h} s from {t_start} s; allowed are those of {self.h} s from "
                        f"{self.t_start} s")
        self.time, self.next, self._node, self._whole = time, t_start + node * h, node, bool(whole)


class SavedModel:
    """What FixedStep and Sampled have in common: a model, its grid of own steps or instants, and saved copies of both."""

    _HEAD = struct.calcsize("<dddqB")  #: bytes of a grid's place

    def __init__(self, model: Any) -> None:
        self.model = model
        self._info: Info = model.info()
        self._info.abilities |= Abilities.RESTARTS
        if hasattr(model, "state"):
            self._info.abilities |= Abilities.SAVES_STATE | Abilities.SERIALIZES_STATE
        self._grid = TimeGrid(0.0, 1.0)
        self._saved: Dict[int, bytes] = {}
        self._last_id = 0

    def info(self) -> Info:
        return self._info

    def _clock(self) -> Clock:
        raise NotImplementedError

    def save_state(self) -> int:
        numbers = [float(x) for x in self.model.state()]
        return self._keep(self._grid.place() + struct.pack(f"<{len(numbers)}d", *numbers))

    def restore_state(self, state: int) -> Clock:
        place, numbers = self._parts(self._find(state))
        self._grid.put(place)
        self.model.set_state(numbers)
        return self._clock()

    def release_state(self, state: int) -> None:
        self._find(state)
        del self._saved[state]

    def serialize_state(self, state: int) -> bytes:
        return self._find(state)

    def deserialize_state(self, data: bytes) -> int:
        expected = self._HEAD + 8 * len(self.model.state())
        if len(data) != expected:
            raise Error(f"the state has {len(data)} bytes; allowed are {expected}")
        TimeGrid(self._grid.t_start, self._grid.h).put(self._parts(data)[0])
        return self._keep(bytes(data))

    def _keep(self, data: bytes) -> int:
        self._last_id += 1
        self._saved[self._last_id] = data
        return self._last_id

    def _find(self, state: int) -> bytes:
        if state not in self._saved:
            raise Error(f"subsystem '{self._info.name}' has no saved state {state}")
        return self._saved[state]

    def _parts(self, data: bytes) -> Tuple[bytes, Tuple[float, ...]]:
        numbers = (len(data) - self._HEAD) // 8
        return bytes(data[:self._HEAD]), struct.unpack(f"<{numbers}d", data[self._HEAD:])


def _next_jump(u: Sequence[Signal], t: float) -> float:
    return min((signal.next_jump(t) for signal in u), default=math.inf)


class FixedStep(SavedModel):
    """Makes a model with a fixed own step a subsystem: it does the grid, landing, early returns and samples, and splits
    steps where an input jumps. A model has

        info() -> Info
        own_step() -> float                                   # h [s]
        start(t, u0)                                          # puts the state at t; u0 may hold NaN
        step(begin, end, h, u)                                # integrates; reads u[i].value(t) anywhere in it
        outputs() -> Sequence[float]                          # outputs, then derivatives, as the state is

    and may have, so that the run can be saved and resumed,

        state() -> Sequence[float]                            # all that its steps go by and that start() does not make
        set_state(numbers)

    and, where inputs feed through,

        jump(t, u) -> bool                                    # inputs have jumped at t, where it stands: have outputs?
    """

    def __init__(self, model: Any) -> None:
        super().__init__(model)
        self._info.abilities |= Abilities.LANDS
        self._u: Sequence[Signal] = ()
        self._jump = math.inf

    def initialize(self, t_start: float, t_stop: float, u0: Sequence[float], rows: List[Row], room: int) -> Clock:
        self._grid = TimeGrid(t_start, self.model.own_step())
        self.model.start(t_start, u0)
        self._append(rows)
        return self._clock()

    def advance(self, t_limit: float, land: bool, u: Sequence[Signal], rows: List[Row], room: int) -> Clock:
        grid = self._grid
        self._u, self._jump = u, _next_jump(u, grid.time)
        if len(rows) < room and self._have_jumped():
            self._take_jump(rows)
        while len(rows) < room:
            fits = grid.fits(t_limit)
            if not fits and not (land and grid.cuts(t_limit)):
                return self._clock()
            if self._pass_jumps() and self._take_jump(rows):
                continue
            if fits:
                self._integrate(grid.time, grid.next, grid.length())
                grid.step()
            else:
                self._integrate(grid.time, t_limit, t_limit - grid.time)
                grid.cut(t_limit)
            self._append(rows)
        return self._clock(Stop.SAMPLES_FULL)

    def _have_jumped(self) -> bool:
        """Inputs, where the call begins."""
        first = (signal.segments[0] for signal in self._u)
        return any(s.jumps() and not before(s.origin, self._grid.time, self._grid.t_start) for s in first)

    def _pass_jumps(self) -> bool:
        """Inputs may also jump where a step of this call has ended."""
        grid, any_jump = self._grid, False
        while self._jump < grid.next and not before(grid.time, self._jump, grid.t_start):
            self._pass(self._jump)
            any_jump = True
        return any_jump

    def _pass(self, t: float) -> None:
        self._u = [signal.from_jump_at(t) for signal in self._u]
        self._jump = _next_jump(self._u, t)

    def _take_jump(self, rows: List[Row]) -> bool:
        """A second row where it stands, if outputs have jumped with inputs."""
        jumps = hasattr(self.model, "jump") and self.model.jump(self._grid.time, self._u)
        if jumps:
            rows.append(Row(self._grid.time, list(self.model.outputs()), True))
        return jumps

    def _integrate(self, begin: float, end: float, h: float) -> None:
        """A step, in parts from one jump of an input to the next (tandem::Jumps)."""
        t_start = self._grid.t_start
        while before(self._jump, end, t_start):
            t = self._jump
            if before(begin, t, t_start):
                self.model.step(begin, t, t - begin, self._u)
                begin, h = t, end - t
            self._pass(t)
        self.model.step(begin, end, h, self._u)

    def _append(self, rows: List[Row]) -> None:
        rows.append(Row(self._grid.time, list(self.model.outputs())))

    def _clock(self, stop: Stop = Stop.LIMIT) -> Clock:
        return Clock(self._grid.time, self._grid.next, stop)


class Sampled(SavedModel):
    """Makes a model that is written for FixedStep a sampled subsystem, by this word in place of the other: own_step()
    is its period T, without derivatives of its outputs. At each instant t_start + offset + k T it gives its outputs, as
    its state is, and steps from there to the next instant on its inputs as they were at this one. Before the first
    instant the outputs of the model as it was started hold. The model may also have

        offset() -> float                                     # of the first instant [s], 0 or more
        latency() -> float                                    # its outputs change so long after each [s]

    and, where inputs feed through, outputs(u=None): at an instant u are their values, None at the start.
    """

    def __init__(self, model: Any) -> None:
        super().__init__(model)
        self._info.abilities |= Abilities.SAMPLED
        self._info.period = model.own_step()
        self._info.latency = model.latency() if hasattr(model, "latency") else 0.0
        for port in self._info.outputs:
            port.held = True
        self._t_start = 0.0

    def initialize(self, t_start: float, t_stop: float, u0: Sequence[float], rows: List[Row], room: int) -> Clock:
        self._t_start = t_start
        first = t_start + self.model.offset() if hasattr(self.model, "offset") else t_start
        self._grid = TimeGrid(first, self.model.own_step())
        self.model.start(t_start, u0)
        rows.append(Row(t_start, list(self.model.outputs())))
        return self._clock()

    def sample(self, t: float, part: Part, u: Sequence[float]) -> Tuple[Clock, Sequence[float]]:
        """The outputs are empty where they are not asked for."""
        outputs: Sequence[float] = []
        if part & Part.OUTPUTS:
            outputs = list(self.model.outputs(u) if self._info.feedthrough else self.model.outputs())
        if part & Part.STATES:
            hold = [Signal((Segment(t, t, (value,)),)) for value in u]
            self.model.step(t, self._grid.next, self._grid.h, hold)
            self._grid.step()
        return self._clock(), outputs

    def _clock(self) -> Clock:
        steps = self._grid.steps()
        return Clock(self._grid.node(steps - 1) if steps else self._t_start, self._grid.time)
