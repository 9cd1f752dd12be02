# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Drives a subsystem of tandem from Python: Python is the master then."""

from __future__ import annotations

import math
import struct
from typing import Any, Callable, List, Optional, Sequence, Tuple

from . import wire
from .address import connected
from .contract import Clock, Error, Info, Row, Signal, Stop, before
from .program import Program


class Remote:
    """A subsystem at the other end of a connection. Each call is one request and one reply; errors name the
    address, the call and the time in the run."""

    def __init__(self, channel: wire.Channel, parameters: str = "", deadline: float = 5.0,
                 program: Optional[Program] = None) -> None:
        self._channel, self._deadline, self._program = channel, deadline, program
        self._number = 0
        self._t_start = self._time = math.nan  # where the subsystem started, and stands
        try:
            self._exchange(wire.Type.HELLO, wire.put_hello(parameters), _read_hello)
            self._info = self._exchange(wire.Type.INFO, b"", wire.read_info)
        except Error:
            self._end()
            raise

    def info(self) -> Info:
        return self._info

    def initialize(self, t_start: float, t_stop: float, u0: Sequence[float]) -> Tuple[Clock, List[Row]]:
        self._t_start, self._time = t_start, t_start
        return self._exchange(wire.Type.INITIALIZE, wire.put_initialize(t_start, t_stop, 1, u0),
                              lambda data: wire.read_samples(data, self._info, 1))

    def advance(self, t_limit: float, u: Sequence[Signal], land: bool = False,
                room: int = 1000) -> Tuple[Clock, List[Row]]:
        """All own steps that fit; `clock.stop` is SAMPLES_FULL if there were more than `room`: call again."""
        clock, rows = self._exchange(wire.Type.ADVANCE, wire.put_advance(t_limit, land, room, u),
                                     lambda data: self._checked(wire.read_samples(data, self._info, room), t_limit),
                                     f" to {_text(t_limit)} s")
        self._time = clock.time
        return clock, rows

    def _checked(self, there: Tuple[Clock, List[Row]], t_limit: float) -> Tuple[Clock, List[Row]]:
        """Rows of an advance, and a clock that is of the newest."""
        clock, rows = there
        last = self._time
        for row in rows:
            later = row.time > last or row.jump and row.time == last
            if not later or not math.isfinite(row.time) or before(t_limit, row.time, self._t_start):
                raise Error(f"it gives a sample at t = {row.time} s; allowed are times after {last} s up to "
                            f"{t_limit} s", 4)
            if not all(map(math.isfinite, row.values)):
                raise Error(f"it gives a value at t = {row.time} s that is not finite", 4)
            last = row.time
        if clock.time != last or not (clock.next_time > last or clock.stop == Stop.FINISHED):
            raise Error(f"it stands at t = {clock.time} s and goes on to {clock.next_time} s; allowed is the time of "
                        f"its newest sample, {last} s, and a later one", 4)
        return there

    def save_state(self) -> int:
        return self._exchange(wire.Type.SAVE, b"", _read_number)

    def restore_state(self, state: int) -> Clock:
        clock = self._exchange(wire.Type.RESTORE, struct.pack("<q", state),
                               lambda data: wire.read_clock(wire.Reader(data, "restore")))
        self._time = clock.time
        return clock

    def release_state(self, state: int) -> None:
        self._exchange(wire.Type.RELEASE, struct.pack("<q", state))

    def serialize_state(self, state: int) -> bytes:
        return self._exchange(wire.Type.SERIALIZE, struct.pack("<q", state), bytes)

    def deserialize_state(self, data: bytes) -> int:
        return self._exchange(wire.Type.DESERIALIZE, data, _read_number)

    def close(self) -> None:
        self._number += 1
        try:
            self._channel.send(wire.Type.BYE, self._number, b"", self._deadline)
        except Error:
            pass
        self._end()

    def _end(self) -> None:
        self._channel.close()
        if self._program is not None:
            self._program.end()

    def __enter__(self) -> "Remote":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _exchange(self, kind: wire.Type, payload: bytes, read: Callable[[memoryview], Any] = lambda data: None,
                  goal: str = "") -> Any:
        """The reply to a request, as `read` takes it apart."""
        self._number += 1
        try:
            self._send(kind, payload)
            return read(self._reply(wire.Type.SAMPLES if kind in _GIVE_SAMPLES else kind))
        except Error as error:
            when = "" if math.isnan(self._time) else f" at t = {_text(self._time)} s"
            raise Error(f"{self._channel.peer}, {kind.name.lower()}{when}{goal}: {error}", error.code) from None

    def _reply(self, expected: wire.Type) -> memoryview:
        try:
            frame = self._channel.receive(self._deadline, self._deadline)
        except Error as error:
            raise self._lost(error) from None
        if frame is None:
            raise self._lost(Error("the peer closed the connection", 5))
        answer, number, data = frame
        if answer == wire.Type.ERROR:
            raise wire.read_error(data)
        if number != self._number or answer != expected:
            raise Error(f"the reply is of type {answer.name.lower()} and number {number}; allowed are "
                        f"{expected.name.lower()} and {self._number}", 3)
        return data

    def _send(self, kind: wire.Type, payload: bytes) -> None:
        """A server that ended the session may have said why before it closed."""
        try:
            self._channel.send(kind, self._number, payload, self._deadline)
        except Error as error:
            try:
                frame = self._channel.receive(0.1, 0.1)
            except Error:
                frame = None
            if frame is not None and frame[0] == wire.Type.ERROR:
                raise wire.read_error(frame[2]) from None
            raise self._lost(error) from None

    def _lost(self, error: Error) -> Error:
        """What became of the program, if that is the reason."""
        fate = self._program.fate() if self._program else None
        return Error(fate, 5) if fate else error


_GIVE_SAMPLES = (wire.Type.INITIALIZE, wire.Type.ADVANCE)


def _read_hello(data: memoryview) -> None:
    lowest, highest, _, _ = wire.read_hello(data)
    if (lowest, highest) != (wire.VERSION, wire.VERSION):
        raise Error(f"the peer speaks version {lowest} to {highest}; allowed is {wire.VERSION}", 2)


def _read_number(data: memoryview) -> int:
    return wire.Reader(data, "state").take("q")[0]


def _text(time: float) -> str:
    text = repr(float(time))
    return text[:-2] if text.endswith(".0") else text


def connect(uri: str, deadline: float = 5.0, allow_plaintext: bool = False) -> Remote:
    """Opens "tcp://HOST:PORT", "unix:PATH" or "spawn:COMMAND", with ?key=value&key=value for the subsystem; a
    `deadline` among them [s] is that of the connection and of each reply."""
    address, _, query = uri.partition("?")
    pairs = query.split("&")
    parameters = "&".join(pair for pair in pairs if not pair.startswith("deadline="))
    for pair in pairs:
        if pair.startswith("deadline="):
            deadline = _seconds(address, pair[9:])
    if address.startswith("spawn:"):
        program = Program(address[6:])
        return Remote(wire.Channel(program.socket, address), parameters, deadline, program)
    try:
        sock = connected(address, deadline, allow_plaintext)
    except OSError as error:
        raise Error(f"no connection to {address}: {error}", 5) from None
    return Remote(wire.Channel(sock, address), parameters, deadline)


def _seconds(address: str, text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not 0.0 < seconds < math.inf:
        raise Error(f"{address}: the deadline is '{text}'; allowed is a number above 0")
    return seconds
