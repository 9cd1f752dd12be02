# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Drives a subsystem of tandem from Python: Python is the master then."""

from __future__ import annotations

import os
import shlex
import socket
import struct
import subprocess
from typing import List, Optional, Sequence, Tuple

from . import wire
from .address import connected
from .contract import Clock, Error, Info, Row, Signal


class Remote:
    """A subsystem at the other end of a connection. Each call is one request and one reply; errors name the
    address and the call."""

    def __init__(self, channel: wire.Channel, parameters: str = "", deadline: float = 5.0,
                 process: Optional["subprocess.Popen[bytes]"] = None) -> None:
        self._channel, self._deadline, self._process = channel, deadline, process
        self._number = 0
        lowest, highest, _, _ = wire.read_hello(self._exchange(wire.Type.HELLO, wire.put_hello(parameters)))
        if (lowest, highest) != (wire.VERSION, wire.VERSION):
            raise Error(f"{channel.peer} speaks version {lowest} to {highest}; allowed is {wire.VERSION}", 2)
        self._info = wire.read_info(self._exchange(wire.Type.INFO, b""))

    def info(self) -> Info:
        return self._info

    def initialize(self, t_start: float, t_stop: float, u0: Sequence[float]) -> Tuple[Clock, List[Row]]:
        data = self._exchange(wire.Type.INITIALIZE, wire.put_initialize(t_start, t_stop, 1, u0),
                              wire.Type.SAMPLES)
        return wire.read_samples(data, self._info, 1)

    def advance(self, t_limit: float, u: Sequence[Signal], land: bool = False,
                room: int = 1000) -> Tuple[Clock, List[Row]]:
        """All own steps that fit; `clock.stop` is SAMPLES_FULL if there were more than `room`: call again."""
        data = self._exchange(wire.Type.ADVANCE, wire.put_advance(t_limit, land, room, u), wire.Type.SAMPLES)
        return wire.read_samples(data, self._info, room)

    def save_state(self) -> int:
        return struct.unpack("<q", self._exchange(wire.Type.SAVE, b""))[0]

    def restore_state(self, state: int) -> Clock:
        data = self._exchange(wire.Type.RESTORE, struct.pack("<q", state))
        return wire.read_clock(wire.Reader(data, "restore"))

    def release_state(self, state: int) -> None:
        self._exchange(wire.Type.RELEASE, struct.pack("<q", state))

    def serialize_state(self, state: int) -> bytes:
        return bytes(self._exchange(wire.Type.SERIALIZE, struct.pack("<q", state)))

    def deserialize_state(self, data: bytes) -> int:
        return struct.unpack("<q", self._exchange(wire.Type.DESERIALIZE, data))[0]

    def close(self) -> None:
        self._number += 1
        try:
            self._channel.send(wire.Type.BYE, self._number, b"", self._deadline)
        except Error:
            pass
        self._channel.close()
        if self._process is not None:
            try:
                self._process.wait(2.0)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()

    def __enter__(self) -> "Remote":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _exchange(self, kind: wire.Type, payload: bytes, expected: Optional[wire.Type] = None) -> memoryview:
        self._number += 1
        where = f"{self._channel.peer}, {kind.name.lower()}: "
        try:
            self._send(kind, payload)
            frame = self._channel.receive(self._deadline, self._deadline)
        except Error as error:
            raise Error(where + str(error), error.code) from None
        if frame is None:
            raise Error(where + "the peer closed the connection", 5)
        answer, number, data = frame
        if answer == wire.Type.ERROR:
            error = wire.read_error(data)
            raise Error(where + str(error), error.code)
        if number != self._number or answer != (expected or kind):
            raise Error(where + f"the reply is of type {answer.name.lower()} and number {number}", 3)
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
                error = wire.read_error(frame[2])
            raise error from None


def connect(uri: str, deadline: float = 5.0, allow_plaintext: bool = False) -> Remote:
    """Opens "tcp://HOST:PORT", "unix:PATH" or "spawn:COMMAND", with ?key=value&key=value for the subsystem."""
    address, _, parameters = uri.partition("?")
    if address.startswith("spawn:"):
        ours, theirs = socket.socketpair()
        with theirs:
            process = subprocess.Popen(shlex.split(address[6:]), pass_fds=[theirs.fileno()],
                                       env={**os.environ, "TANDEM_FD": str(theirs.fileno())})
        return Remote(wire.Channel(ours, address), parameters, deadline, process)
    try:
        sock = connected(address, deadline, allow_plaintext)
    except OSError as error:
        raise Error(f"no connection to {address}: {error}", 5) from None
    return Remote(wire.Channel(sock, address), parameters, deadline)
