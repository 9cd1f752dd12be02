# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The contract of a subsystem (docs/contract.md), in the words of the C and C++ headers."""

from __future__ import annotations

import enum
import math
import struct
import sys
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Sequence, Tuple

NAN = float("nan")


class Error(Exception):
    """One sentence with a code: 1 invalid argument, 2 not supported, 3 wrong state, 4 numerical, 5 input or
    output, 6 anything else."""

    def __init__(self, sentence: str, code: int = 1) -> None:
        super().__init__(sentence)
        self.code = code


class Stop(enum.IntEnum):
    """Why a call returned."""

    LIMIT = 0
    EVENT = 1
    SAMPLES_FULL = 2
    FINISHED = 3


class Abilities(enum.IntFlag):
    NONE = 0
    CHOOSES_STEP = 1
    LANDS = 2
    SAVES_STATE = 4
    RESTARTS = 8
    REACTIVE_INPUTS = 16
    SERIALIZES_STATE = 32


@dataclass
class Port:
    """An input or output of `size` scalars. derivatives: how many time derivatives an output gives with each
    sample (0 to 3). start: the value of an input when nothing else is known."""

    name: str
    unit: str = "1"
    size: int = 1
    derivatives: int = 0
    start: float = NAN


@dataclass
class Info:
    name: str
    inputs: List[Port] = field(default_factory=list)
    outputs: List[Port] = field(default_factory=list)
    #: pairs (output, input), flattened: that output at t depends on that input at the same t
    feedthrough: List[Tuple[int, int]] = field(default_factory=list)
    abilities: Abilities = Abilities.NONE

    def input_size(self) -> int:
        return sum(port.size for port in self.inputs)

    def output_size(self) -> int:
        return sum(port.size for port in self.outputs)

    def derivatives(self) -> int:
        return max((port.derivatives for port in self.outputs), default=0)

    def row_size(self) -> int:
        """Numbers in a sample: time, jump flag, outputs, their first derivatives, their second ones, ..."""
        return 2 + self.output_size() * (1 + self.derivatives())


@dataclass(frozen=True)
class Segment:
    """sum of c[k] (t - origin)^k for t <= end."""

    end: float
    origin: float
    c: Tuple[float, ...]


class Signal:
    """One scalar input as a function of time over the span of a call: a piecewise polynomial."""

    __slots__ = ("segments",)

    def __init__(self, segments: Sequence[Segment]) -> None:
        self.segments = segments

    def _at(self, t: float) -> Segment:
        for segment in self.segments:
            if t <= segment.end:
                return segment
        return self.segments[-1]

    def value(self, t: float) -> float:
        """In the order of operations of tandem/signal.h, so that the bits are the same."""
        s = self._at(t)
        c = s.c if len(s.c) == 6 else s.c + (0.0,) * (6 - len(s.c))
        x = t - s.origin
        x2 = x * x
        return (c[0] + c[1] * x) + x2 * ((c[2] + c[3] * x) + x2 * (c[4] + c[5] * x))

    __call__ = value

    def derivative(self, t: float) -> float:
        s = self._at(t)
        x = t - s.origin
        v = 0.0
        for k in range(len(s.c) - 1, 0, -1):
            v = v * x + k * s.c[k]
        return v


def constant(value: float) -> Signal:
    """An input that does not change."""
    return Signal((Segment(0.0, 0.0, (value,)),))


@dataclass
class Clock:
    """Where a subsystem stands [s], where its next own step would end, and why it returned."""

    time: float
    next_time: float
    stop: Stop = Stop.LIMIT


@dataclass
class Row:
    """A sample: the outputs after an own step, then their first derivatives, their second ones, ... (0 where a
    port has fewer). jump: nothing before it may be fitted together with it."""

    time: float
    values: Sequence[float]
    jump: bool = False


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

    def place(self) -> bytes:
        """Where it stands, as bytes (tandem::TimeGrid::write)."""
        return struct.pack("<dddqB", self.t_start, self.h, self.time, self._node, self._whole)

    def put(self, place: bytes) -> None:
        t_start, h, time, node, whole = struct.unpack("<dddqB", place)
        if (t_start, h) != (self.t_start, self.h):
            raise Error(f"the state is of own steps of {h} s from {t_start} s; allowed are those of {self.h} s from "
                        f"{self.t_start} s")
        self.time, self.next, self._node, self._whole = time, t_start + node * h, node, bool(whole)


class FixedStep:
    """Makes a model with a fixed own step a subsystem: it does the grid, landing, early returns and samples. A
    model has

        info() -> Info
        own_step() -> float                                   # h [s]
        start(t, u0)                                          # puts the state at t; u0 may hold NaN
        step(begin, end, h, u)                                # integrates; reads u[i].value(t) anywhere in it
        outputs() -> Sequence[float]                          # outputs, then derivatives, as the state is

    and may have, so that the run can be saved and resumed,

        state() -> Sequence[float]                            # all that its steps go by and that start() does not make
        set_state(numbers)
    """

    def __init__(self, model: object) -> None:
        self.model = model
        self._info = model.info()  # type: ignore[attr-defined]
        self._info.abilities |= Abilities.LANDS | Abilities.RESTARTS
        if hasattr(model, "state"):
            self._info.abilities |= Abilities.SAVES_STATE | Abilities.SERIALIZES_STATE
        self._grid: Optional[TimeGrid] = None
        self._saved: Dict[int, bytes] = {}
        self._last_id = 0

    def info(self) -> Info:
        return self._info

    def initialize(self, t_start: float, t_stop: float, u0: Sequence[float], rows: List[Row], room: int) -> Clock:
        self._grid = TimeGrid(t_start, self.model.own_step())  # type: ignore[attr-defined]
        self.model.start(t_start, u0)  # type: ignore[attr-defined]
        self._append(rows)
        return self._clock(Stop.LIMIT)

    def advance(self, t_limit: float, land: bool, u: Sequence[Signal], rows: List[Row], room: int) -> Clock:
        grid, model = self._grid, self.model
        assert grid is not None
        while len(rows) < room:
            if grid.fits(t_limit):
                model.step(grid.time, grid.next, grid.length(), u)  # type: ignore[attr-defined]
                grid.step()
            elif land and grid.cuts(t_limit):
                model.step(grid.time, t_limit, t_limit - grid.time, u)  # type: ignore[attr-defined]
                grid.cut(t_limit)
            else:
                return self._clock(Stop.LIMIT)
            self._append(rows)
        return self._clock(Stop.SAMPLES_FULL)

    def save_state(self) -> int:
        assert self._grid is not None
        numbers = [float(x) for x in self.model.state()]  # type: ignore[attr-defined]
        return self._keep(self._grid.place() + struct.pack(f"<{len(numbers)}d", *numbers))

    def restore_state(self, state: int) -> Clock:
        assert self._grid is not None
        place, numbers = self._parts(self._find(state))
        self._grid.put(place)
        self.model.set_state(numbers)  # type: ignore[attr-defined]
        return self._clock(Stop.LIMIT)

    def release_state(self, state: int) -> None:
        self._find(state)
        del self._saved[state]

    def serialize_state(self, state: int) -> bytes:
        return self._find(state)

    def deserialize_state(self, data: bytes) -> int:
        assert self._grid is not None
        expected = struct.calcsize("<dddqB") + 8 * len(self.model.state())  # type: ignore[attr-defined]
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

    @staticmethod
    def _parts(data: bytes) -> Tuple[bytes, Tuple[float, ...]]:
        head = struct.calcsize("<dddqB")
        return bytes(data[:head]), struct.unpack(f"<{(len(data) - head) // 8}d", data[head:])

    def _append(self, rows: List[Row]) -> None:
        assert self._grid is not None
        rows.append(Row(self._grid.time, list(self.model.outputs())))  # type: ignore[attr-defined]

    def _clock(self, stop: Stop) -> Clock:
        assert self._grid is not None
        return Clock(self._grid.time, self._grid.next, stop)
