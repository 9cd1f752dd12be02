# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Frames of docs/wire_protocol.md on a socket."""

from __future__ import annotations

import contextlib
import enum
import socket
import struct
import time
from typing import Optional, Tuple, Union

from .contract import Error

LONGEST = 1 << 26  # bytes of a payload
HEADER = struct.Struct("<QII")
Payload = Union[bytes, bytearray, memoryview]


class Type(enum.IntEnum):
    HELLO = 1
    INFO = 2
    INITIALIZE = 3
    ADVANCE = 4
    SAMPLES = 5
    SAVE = 6
    RESTORE = 7
    RELEASE = 8
    PING = 9
    ERROR = 10
    BYE = 11
    SERIALIZE = 12
    DESERIALIZE = 13
    SAMPLE = 14


class Channel:
    """Frames on a connected socket."""

    def __init__(self, sock: socket.socket, peer: str) -> None:
        self._socket, self.peer = sock, peer
        if sock.family in (socket.AF_INET, socket.AF_INET6):
            with contextlib.suppress(OSError):  # a peer that is gone; whoever uses it is told
                sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

        self._begun = b""  # what has come of the next frame

    def send(self, kind: Type, number: int, payload: Payload, deadline: float) -> None:
        head = HEADER.pack(len(payload), kind, number)
        self._socket.settimeout(deadline)
        try:
            if len(payload) < 1 << 16:
                self._socket.sendall(head + payload)
            else:  # which is not to be copied
                self._socket.sendall(head)
                self._socket.sendall(payload)
        except OSError as error:
            raise Error(f"the connection broke: {error}", 5) from None

    def wait(self, seconds: float) -> bool:
        """For the beginning of a frame, or the end of the connection. False: there was none by then."""
        if not self._begun:
            part = self._part(HEADER.size, time.monotonic() + seconds)
            self._begun = part or b""
            return part is not None
        return True

    def receive(self, deadline: float, until: Optional[float] = None) -> Optional[Tuple[Type, int, memoryview]]:
        """The next frame, whole within so many seconds; None at the end of the connection. until: when they are over
        on the monotonic clock, if they began before."""
        until = time.monotonic() + deadline if until is None else until
        head, self._begun = bytearray(self._begun), b""
        if not self._fill(head, HEADER.size, until, deadline):
            return None
        length, kind, number = HEADER.unpack(head)
        if not 1 <= kind <= max(Type):
            raise Error(f"the frame has the type {kind}; allowed are 1 to {max(Type)}")
        if length > LONGEST:
            raise Error(f"the frame '{Type(kind).name.lower()}' announces {length} bytes; allowed are up to {LONGEST}")
        payload = bytearray()
        if not self._fill(payload, length, until, deadline):
            raise Error("the peer closed the connection within a frame", 5)
        return Type(kind), number, memoryview(payload)

    def _fill(self, data: bytearray, size: int, until: float, deadline: float) -> bool:
        """False: the connection ended before anything came. Memory grows with what has come."""
        while len(data) < size:
            part = self._part(size - len(data), until)
            if part is None:
                raise Error(f"no frame came whole within {deadline} s", 5)
            if not part and data:
                raise Error("the peer closed the connection within a frame", 5)
            if not part:
                return False
            data += part
        return True

    def _part(self, most: int, until: float) -> Optional[bytes]:
        """What has come: nothing at the end; None if there was none by then."""
        while True:
            left = until - time.monotonic()
            if left <= 0.0:
                return None
            self._socket.settimeout(min(left, 1e6))
            try:
                return self._socket.recv(min(most, 1 << 18))
            except socket.timeout:
                pass
            except OSError as error:
                raise Error(f"the connection broke: {error}", 5) from None

    def close(self) -> None:
        self._socket.close()
