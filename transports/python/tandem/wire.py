# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The protocol of docs/wire_protocol.md: bytes to values and back, and frames on a socket."""

from __future__ import annotations

import enum
import math
import socket
import struct
import time
from typing import List, Optional, Sequence, Tuple

from .contract import Abilities, Clock, Error, Info, Port, Row, Segment, Signal, Stop

VERSION = 1
MAGIC = b"TANDEM\r\n"
LONGEST = 1 << 26
HEADER = struct.Struct("<QII")


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


class Reader:
    """Takes a payload apart; what is not there is refused before memory is taken for it."""

    def __init__(self, data: memoryview, what: str) -> None:
        self._data, self._what, self._place = data, what, 0

    def left(self) -> int:
        return len(self._data) - self._place

    def take(self, form: str) -> Tuple:
        size = struct.calcsize("<" + form)
        if size > self.left():
            self.refuse(f"ends after {len(self._data)} bytes; at byte {self._place} {size} more were to follow")
        values = struct.unpack_from("<" + form, self._data, self._place)
        self._place += size
        return values

    def text(self, longest: int) -> str:
        (length,) = self.take("I")
        if length > min(longest, self.left()):
            self.refuse(f"has a text of {length} bytes; allowed are up to {min(longest, self.left())}")
        data = bytes(self._data[self._place:self._place + length])
        self._place += length
        return data.decode("utf-8", "replace")

    def count(self, bytes_each: int) -> int:
        (count,) = self.take("I")
        if count * bytes_each > self.left():
            self.refuse(f"announces {count} things, but only {self.left()} bytes follow")
        return count

    def end(self) -> None:
        if self.left():
            self.refuse(f"has {self.left()} bytes more than it should")

    def refuse(self, sentence: str) -> None:
        raise Error(f"the message '{self._what}' {sentence}")


def put_text(text: str) -> bytes:
    data = text.encode()
    return struct.pack("<I", len(data)) + data


def put_hello(text: str) -> bytes:
    return MAGIC + struct.pack("<IIQI", VERSION, VERSION, LONGEST, 0) + put_text(text)


def read_hello(data: memoryview) -> Tuple[int, int, int, str]:
    """Lowest and highest version, longest payload, text."""
    reader = Reader(data, "hello")
    if bytes(data[:8]) != MAGIC:
        reader.refuse("does not begin with TANDEM, so the peer speaks something else")
    reader.take("8s")
    lowest, highest, longest, _ = reader.take("IIQI")
    text = reader.text(1 << 20)
    reader.end()
    return lowest, highest, longest, text


def put_info(info: Info) -> bytes:
    parts = [put_text(info.name), struct.pack("<I", int(info.abilities))]
    for ports in (info.inputs, info.outputs):
        parts.append(struct.pack("<I", len(ports)))
        for p in ports:
            parts += [put_text(p.name), put_text(p.unit), struct.pack("<iid", p.size, p.derivatives, p.start)]
    parts.append(struct.pack("<I", len(info.feedthrough)))
    parts += [struct.pack("<ii", *pair) for pair in info.feedthrough]
    return b"".join(parts)


def read_info(data: memoryview) -> Info:
    reader = Reader(data, "info")
    name = reader.text(4096)
    abilities = Abilities(reader.take("I")[0] & 63)
    ports: List[List[Port]] = []
    for _ in range(2):
        ports.append([Port(reader.text(4096), reader.text(4096), *reader.take("iid"))
                      for _ in range(reader.count(24))])
    feedthrough = [reader.take("ii") for _ in range(reader.count(8))]
    reader.end()
    return Info(name, ports[0], ports[1], feedthrough, abilities)


def put_initialize(t_start: float, t_stop: float, room: int, u0: Sequence[float]) -> bytes:
    return struct.pack(f"<ddQI{len(u0)}d", t_start, t_stop, room, len(u0), *u0)


def read_initialize(data: memoryview, inputs: int) -> Tuple[float, float, int, List[float]]:
    reader = Reader(data, "initialize")
    t_start, t_stop, room = reader.take("ddQ")
    check_inputs(reader, reader.count(8), inputs)
    u0 = list(reader.take(f"{inputs}d"))
    reader.end()
    return t_start, t_stop, room, u0


def check_inputs(reader: Reader, found: int, inputs: int) -> None:
    if found != inputs:
        reader.refuse(f"has {found} inputs; allowed are {inputs}")


def put_advance(t_limit: float, land: bool, room: int, u: Sequence[Signal]) -> bytes:
    parts = [struct.pack("<dIIQ", t_limit, int(land), len(u), room)]
    for signal in u:
        degree = max(len(s.c) for s in signal.segments) - 1
        parts.append(struct.pack("<II", len(signal.segments), degree))
        for s in signal.segments:
            c = tuple(s.c) + (0.0,) * (degree + 1 - len(s.c))
            parts.append(struct.pack(f"<{degree + 3}d", s.end, s.origin, *c))
    return b"".join(parts)


def read_advance(data: memoryview, inputs: int) -> Tuple[float, bool, int, List[Signal]]:
    reader = Reader(data, "advance")
    t_limit, land, count, room = reader.take("dIIQ")
    if land > 1 or not math.isfinite(t_limit):
        reader.refuse(f"has t_limit {t_limit} and land {land}; allowed are a finite time, and 0 or 1")
    check_inputs(reader, count, inputs)
    return t_limit, bool(land), room, [read_signal(reader) for _ in range(count)] + end_of(reader)


def end_of(reader: Reader) -> List[Signal]:
    reader.end()
    return []


def read_signal(reader: Reader) -> Signal:
    count, degree = reader.take("II")
    if count == 0 or degree > 5 or count * 8 * (degree + 3) > reader.left():
        reader.refuse(f"has an input of {count} segments of degree {degree}; allowed are 1 or more that follow, "
                      "of degree 0 to 5")
    segments = []
    for _ in range(count):
        end, origin, *c = reader.take(f"{degree + 3}d")
        if not all(math.isfinite(x) for x in c) or not math.isfinite(origin) or math.isnan(end):
            reader.refuse("has an input that is not finite")
        segments.append(Segment(end, origin, tuple(c)))
    return Signal(segments)


def put_clock(clock: Clock) -> bytes:
    return struct.pack("<ddI", clock.time, clock.next_time, int(clock.stop))


def put_rows(rows: Sequence[Row], stride: int) -> bytes:
    parts = [struct.pack("<IQ", stride, len(rows))]
    for row in rows:
        if len(row.values) != stride - 2:
            raise Error(f"the sample at t = {row.time} s has {len(row.values)} values; allowed are {stride - 2}")
        try:
            parts.append(struct.pack(f"<{stride}d", row.time, float(row.jump), *row.values))
        except struct.error:
            raise Error(f"the sample at t = {row.time} s has {list(row.values)}; allowed are numbers") from None
    return b"".join(parts)


def read_clock(reader: Reader) -> Clock:
    time_, next_time, stop = reader.take("ddI")
    if stop > 3:
        reader.refuse(f"gives {stop} as the reason to stop; allowed are 0 to 3")
    return Clock(time_, next_time, Stop(stop))


def read_samples(data: memoryview, info: Info, room: int) -> Tuple[Clock, List[Row]]:
    reader = Reader(data, "samples")
    clock = read_clock(reader)
    stride, count = reader.take("IQ")
    if count > room or (count and stride != info.row_size()):
        reader.refuse(f"has {count} rows of {stride} numbers; allowed are up to {room} of {info.row_size()}")
    rows = []
    for _ in range(count):
        time_, jump, *values = reader.take(f"{stride}d")
        rows.append(Row(time_, values, jump != 0.0))
    reader.end()
    return clock, rows


def put_error(error: Error) -> bytes:
    return struct.pack("<I", error.code) + put_text(str(error))


def read_error(data: memoryview) -> Error:
    reader = Reader(data, "error")
    (code,) = reader.take("I")
    return Error(reader.text(1 << 20), code if 1 <= code <= 6 else 6)


class Channel:
    """Frames on a connected socket."""

    def __init__(self, sock: socket.socket, peer: str) -> None:
        self._socket, self.peer = sock, peer
        if sock.family in (socket.AF_INET, socket.AF_INET6):
            sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def send(self, kind: Type, number: int, payload: bytes, deadline: float) -> None:
        self._socket.settimeout(deadline)
        try:
            self._socket.sendall(HEADER.pack(len(payload), kind, number) + payload)
        except OSError as error:
            raise Error(f"the connection broke: {error}", 5) from None

    def receive(self, first: Optional[float], deadline: float) -> Optional[Tuple[Type, int, memoryview]]:
        """The next frame; None at the end of the connection. first: seconds until it begins (None: for ever)."""
        head = self._read(HEADER.size, first, deadline, True)
        if head is None:
            return None
        length, kind, number = HEADER.unpack(head)
        if not 1 <= kind <= max(Type):
            raise Error(f"the frame has the type {kind}; allowed are 1 to {max(Type)}")
        if length > LONGEST:
            raise Error(f"the frame announces {length} bytes; allowed are up to {LONGEST}")
        payload = self._read(length, deadline, deadline, False)
        assert payload is not None
        return Type(kind), number, memoryview(payload)

    def _read(self, size: int, first: Optional[float], deadline: float, may_end: bool) -> Optional[bytes]:
        parts: List[bytes] = []
        left, until = size, time.monotonic() + deadline
        while left:
            wait = first if left == size else max(until - time.monotonic(), 1e-3)
            self._socket.settimeout(wait)
            try:
                part = self._socket.recv(min(left, 1 << 20))
            except socket.timeout:
                raise Error(f"no frame came whole within {wait if left == size else deadline} s", 5) from None
            except OSError as error:
                raise Error(f"the connection broke: {error}", 5) from None
            if not part:
                if may_end and left == size:
                    return None
                raise Error("the peer closed the connection within a frame", 5)
            if left == size:
                until = time.monotonic() + deadline
            parts.append(part)
            left -= len(part)
        return b"".join(parts)

    def close(self) -> None:
        self._socket.close()
