# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Drives a subsystem of tandem from Python: Python is the master then."""

from __future__ import annotations

import math
import struct
from typing import Any, Callable, List, Optional, Sequence, Tuple

from . import reply_checks, wire
from .address import connected
from .contract import Clock, Error, Info, Part, Row, Signal
from .program import Program


class Remote:
    """A subsystem at the other end of a connection. Each call is one request and one reply; errors name the
    address, the call and the time in the run."""

    def __init__(self, channel: wire.Channel, parameters: str = "", deadline: float = 5.0,
                 program: Optional[Program] = None) -> None:
        self._channel, self._deadline, self._program = channel, deadline, program
        self._number = 0
        self._longest = wire.LONGEST  # that the server takes
        self._broken = ""  # why the connection is not used any more
        self._t_start = self._time = math.nan  # where the subsystem started, and stands
        try:
            hello = self._exchange(wire.Type.HELLO, wire.put_hello(parameters), _read_hello)
            self._longest = hello.longest
            self._info = self._exchange(wire.Type.INFO, b"", lambda data: _read_info(data, hello))
        except Error:
            self._end()
            raise

    def info(self) -> Info:
        return self._info

    def initialize(self, t_start: float, t_stop: float, u0: Sequence[float]) -> Tuple[Clock, List[Row]]:
        self._t_start, self._time = t_start, t_start
        clock, rows = self._exchange(wire.Type.INITIALIZE, wire.put_initialize(t_start, t_stop, 1, u0),
                                     lambda data: self._first(data, u0))
        return clock, rows

    def advance(self, t_limit: float, u: Sequence[Signal], land: bool = False,
                room: int = 1000) -> Tuple[Clock, List[Row]]:
        """All own steps that fit; `clock.stop` is SAMPLES_FULL if there were more than `room`: call again."""
        clock, rows = self._exchange(wire.Type.ADVANCE, wire.put_advance(t_limit, land, room, u),
                                     lambda data: self._further(data, room, t_limit),
                                     f" to {reply_checks.seconds(t_limit)}")
        self._time = clock.time
        return clock, rows

    def sample(self, t: float, part: Part, u: Sequence[float]) -> Tuple[Clock, List[float]]:
        """Of a sampled subsystem at its instant t, the next_time of its clock: the outputs, none for its states alone."""
        outputs = self._info.output_size() if part & Part.OUTPUTS else 0
        self._time = t
        return self._exchange(wire.Type.SAMPLE, wire.put_sample(t, part, u),
                              lambda data: self._sampled(data, outputs, part))

    def _sampled(self, data: memoryview, outputs: int, part: Part) -> Tuple[Clock, List[float]]:
        clock, y = wire.read_sampled(data, outputs)
        reply_checks.check_sample(self._info, self._time, y)
        if part & Part.STATES:
            reply_checks.check_next_instant(clock, self._time)
        return clock, y

    def _first(self, data: memoryview, u0: Sequence[float]) -> Tuple[Clock, List[Row]]:
        reply = wire.read_samples(data, self._info, 1)
        reply_checks.check_first(self._info, self._t_start, u0, reply)
        return reply

    def _further(self, data: memoryview, room: int, t_limit: float) -> Tuple[Clock, List[Row]]:
        reply = wire.read_samples(data, self._info, room)
        reply_checks.check_rows(self._info, (self._t_start, self._time, t_limit), reply)
        return reply

    def save_state(self) -> int:
        return self._exchange(wire.Type.SAVE, b"", _read_number)

    def restore_state(self, state: int) -> Clock:
        clock = self._exchange(wire.Type.RESTORE, struct.pack("<q", state), self._restored)
        self._time = clock.time
        return clock

    def _restored(self, data: memoryview) -> Clock:
        reader = wire.Reader(data, "restore")
        clock = wire.read_clock(reader)
        reader.end()
        reply_checks.check_next(self._info, clock)
        return clock

    def release_state(self, state: int) -> None:
        self._exchange(wire.Type.RELEASE, struct.pack("<q", state), lambda data: wire.Reader(data, "release").end())

    def serialize_state(self, state: int) -> bytes:
        return self._exchange(wire.Type.SERIALIZE, struct.pack("<q", state), bytes)

    def deserialize_state(self, data: bytes) -> int:
        return self._exchange(wire.Type.DESERIALIZE, data, _read_number)

    def close(self) -> None:
        if not self._broken:
            self._number += 1
            try:
                self._channel.send(wire.Type.BYE, self._number, b"", self._deadline)
            except Error:
                pass
        self._end()

    def _end(self) -> None:
        self._broken = self._broken or "it was closed"
        self._channel.close()
        if self._program is not None:
            self._program.end()

    def __enter__(self) -> "Remote":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _exchange(self, kind: wire.Type, payload: bytes, read: Callable[[memoryview], Any], goal: str = "") -> Any:
        """The reply to a request, as `read` takes it apart. An error of the connection ends its use."""
        if self._broken:
            raise Error(f"{self._channel.peer}: the connection ended before: {self._broken}", 3)
        self._number += 1
        when = "" if math.isnan(self._time) else f" at t = {reply_checks.seconds(self._time)}"
        where = f"{self._channel.peer}, {kind.name.lower()}{when}{goal}: "
        try:
            self._send(kind, payload)
            return read(self._reply(wire.Type.SAMPLES if kind in _GIVE_SAMPLES else kind))
        except _Told as told:
            error = Error(f"{where}{told.error}", told.error.code)
            error.parameters = told.error.parameters
            raise error from None
        except Error as error:
            self._broken = str(error)
            self._channel.close()
            raise Error(f"{where}{error}", error.code) from None

    def _reply(self, expected: wire.Type) -> memoryview:
        try:
            frame = self._channel.receive(self._deadline)
        except Error as error:
            raise self._lost(error) from None
        if frame is None:
            raise self._lost(Error("the peer closed the connection", 5))
        answer, number, data = frame
        if answer == wire.Type.ERROR and number == 0:
            raise wire.read_error(data)
        if answer == wire.Type.ERROR and number == self._number:
            raise _Told(wire.read_error(data, self._info if expected == wire.Type.SAMPLES else None,
                                        expected == wire.Type.HELLO))
        if number != self._number or answer != expected:
            raise Error(f"the reply is of type {answer.name.lower()} and number {number}; allowed are "
                        f"{expected.name.lower()} and {self._number}", 3)
        return data

    def _send(self, kind: wire.Type, payload: bytes) -> None:
        """A server that ended the session may have said why before it closed."""
        if len(payload) > self._longest:
            raise Error(f"the request has {len(payload)} bytes; the peer takes up to {self._longest}", 2)
        try:
            self._channel.send(kind, self._number, payload, self._deadline)
        except Error as error:
            try:
                frame = self._channel.receive(0.1)
            except Error:
                frame = None
            if frame is not None and frame[0] == wire.Type.ERROR:
                raise wire.read_error(frame[2]) from None
            raise self._lost(error) from None

    def _lost(self, error: Error) -> Error:
        """What became of the program, if that is the reason."""
        fate = self._program.fate() if self._program else None
        return Error(fate, 5) if fate else error


class _Told(Exception):
    """What the subsystem itself says; the connection is as sound as before."""

    def __init__(self, error: Error) -> None:
        super().__init__(error)
        self.error = error


_GIVE_SAMPLES = (wire.Type.INITIALIZE, wire.Type.ADVANCE)


def _read_hello(data: memoryview) -> wire.Hello:
    hello = wire.read_hello(data, wire.CAPABILITIES)
    if (hello.lowest, hello.highest) != (wire.VERSION, wire.VERSION):
        raise Error(f"the peer speaks version {hello.lowest} to {hello.highest}; allowed is {wire.VERSION}", 2)
    return hello


def _read_info(data: memoryview, hello: wire.Hello) -> Info:
    info = wire.read_info(data, hello.capabilities)
    info.parameters = list(hello.declared)
    reply_checks.check_info(info)
    return info


def _read_number(data: memoryview) -> int:
    return wire.read_state(data, "state")


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
