# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The contract of a subsystem (docs/contract.md), in the words of the C and C++ headers."""

from __future__ import annotations

import enum
import math
from dataclasses import dataclass, field
from typing import List, Optional, Sequence, Tuple, Union

NAN = float("nan")


class Error(Exception):
    """One sentence with a code: 1 invalid argument, 2 not supported, 3 wrong state, 4 numerical, 5 input or
    output, 6 anything else. parameters: where a subsystem elsewhere was not made, those that its kind declares."""

    def __init__(self, sentence: str, code: int = 1) -> None:
        super().__init__(sentence)
        self.code = code
        self.parameters: List[Parameter] = []


class Stop(enum.IntEnum):
    """Why a call returned."""

    LIMIT = 0
    EVENT = 1
    SAMPLES_FULL = 2
    FINISHED = 3


class Part(enum.IntFlag):
    """What a sampled subsystem is to do at an instant: to give its outputs, which changes nothing else and may be asked
    again, and to go on to the next instant; the outputs first."""

    OUTPUTS = 1
    STATES = 2


class Abilities(enum.IntFlag):
    NONE = 0
    CHOOSES_STEP = 1
    LANDS = 2
    SAVES_STATE = 4
    RESTARTS = 8
    REACTIVE_INPUTS = 16
    SERIALIZES_STATE = 32
    SAMPLED = 64
    EVENTS = 256


@dataclass
class Port:
    """An input or output of `size` scalars. derivatives: how many time derivatives an output gives with each
    sample (0 to 3). start: the value of an input when nothing else is known. held: an output that is constant from each
    of its samples, that instant included, to the next. nominal: the usual magnitude of an output, above 0."""

    name: str
    unit: str = "1"
    size: int = 1
    derivatives: int = 0
    start: float = NAN
    held: bool = False
    nominal: float = 1.0


@dataclass(frozen=True)
class Parameter:
    """A parameter that a kind of subsystem takes. unit: that of a number, "1" for none; None: it is a word. sentence:
    what it is. otherwise: what stands where none is given; None: one has to be."""

    name: str
    unit: Optional[str]
    sentence: str
    otherwise: Union[float, str, None] = None


@dataclass
class Info:
    name: str
    inputs: List[Port] = field(default_factory=list)
    outputs: List[Port] = field(default_factory=list)
    #: pairs (output, input), flattened: that output at t depends on that input at the same t
    feedthrough: List[Tuple[int, int]] = field(default_factory=list)
    abilities: Abilities = Abilities.NONE
    #: of a sampled subsystem [s]: the least time between two instants, and how long after each its outputs change
    period: float = 0.0
    latency: float = 0.0
    #: of a subsystem elsewhere: those that its kind declares; none: it takes any
    parameters: List[Parameter] = field(default_factory=list)

    def input_size(self) -> int:
        return sum(port.size for port in self.inputs)

    def output_size(self) -> int:
        return sum(port.size for port in self.outputs)

    def holds(self) -> bool:
        return any(port.held for port in self.outputs)

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

    def jumps(self) -> bool:
        """Whether the input jumps at its origin, where it begins (the mark of tandem/signal.h)."""
        return len(self.c) == 6 and self.c[5] == 0.0 and math.copysign(1.0, self.c[5]) < 0.0


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

    def next_jump(self, t: float) -> float:
        """The first time after t at which it is known to jump; inf if there is none."""
        return next((s.origin for s in self.segments if s.jumps() and s.origin > t), math.inf)

    def from_jump_at(self, t: float) -> Signal:
        """From its jump at t on, the last of them, whose value there is the one after; the whole signal if it has none
        there."""
        for k in range(len(self.segments) - 1, -1, -1):
            if self.segments[k].jumps() and self.segments[k].origin == t:
                return Signal(self.segments[k:])
        return self

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
