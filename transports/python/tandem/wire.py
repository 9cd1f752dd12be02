# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The payloads of docs/wire_protocol.md: bytes to values and back."""

from __future__ import annotations

import array
import math
import struct
import sys
from typing import List, Optional, Sequence, Tuple

from .channel import HEADER, LONGEST, Channel, Payload, Type
from .contract import Abilities, Clock, Error, Info, Port, Row, Segment, Signal, Stop
from .printable import printable
from .reply_checks import check_jump

__all__ = ["HEADER", "LONGEST", "Channel", "Payload", "Type"]

VERSION = 1
MAGIC = b"TANDEM\r\n"
LONGEST_NAME = 4096  # bytes
LONGEST_SENTENCE = 1 << 20  # bytes that are read
LONGEST_TOLD = 4000  # bytes of a sentence of ours
#: that a request may have: as objects they take up to 400 bytes each
MOST_SEGMENTS = 1 << 17
AT_ONCE = 1 << 12  # numbers of a row that are put into a reply


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

    def take_doubles(self, count: int) -> array.array:
        """They take no more memory than their bytes did."""
        if 8 * count > self.left():
            self.refuse(f"ends after {len(self._data)} bytes, within {count} numbers")
        values = array.array("d")
        values.frombytes(self._data[self._place:self._place + 8 * count])
        self._place += 8 * count
        if sys.byteorder == "big":
            values.byteswap()
        return values

    def text(self, longest: int) -> str:
        (length,) = self.take("I")
        if length > min(longest, self.left()):
            self.refuse(f"has a text of {length} bytes; allowed are up to {min(longest, self.left())}")
        data = bytes(self._data[self._place:self._place + length])
        self._place += length
        return data.decode("utf-8", "surrogateescape")

    def name(self) -> str:
        """A name or a unit, to be shown."""
        return printable(self.text(LONGEST_NAME), LONGEST_NAME)

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
    data = text.encode("utf-8", "surrogateescape")
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
    text = reader.text(LONGEST_SENTENCE)
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
    name = reader.name()
    abilities = Abilities(reader.take("I")[0] & 63)
    ports: List[List[Port]] = []
    for _ in range(2):
        ports.append([Port(reader.name(), reader.name(), *reader.take("iid"))
                      for _ in range(reader.count(24))])
    feedthrough = [reader.take("ii") for _ in range(reader.count(8))]
    reader.end()
    return Info(name, ports[0], ports[1], feedthrough, abilities)


def put_initialize(t_start: float, t_stop: float, room: int, u0: Sequence[float]) -> bytes:
    return struct.pack(f"<ddQI{len(u0)}d", t_start, t_stop, room, len(u0), *u0)


def read_initialize(data: memoryview, inputs: int) -> Tuple[float, float, int, array.array]:
    reader = Reader(data, "initialize")
    t_start, t_stop, room = reader.take("ddQ")
    if not (math.isfinite(t_start) and math.isfinite(t_stop)):
        reader.refuse(f"has the times {t_start} and {t_stop}; allowed are finite ones")
    check_inputs(reader, reader.count(8), inputs)
    u0 = reader.take_doubles(inputs)
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
    u: List[Signal] = []
    segments = 0
    for _ in range(count):
        u.append(read_signal(reader, MOST_SEGMENTS - segments))
        segments += len(u[-1].segments)
    reader.end()
    return t_limit, bool(land), room, u


def read_signal(reader: Reader, most: int) -> Signal:
    count, degree = reader.take("II")
    if count == 0 or degree > 5 or count * 8 * (degree + 3) > reader.left():
        reader.refuse(f"has an input of {count} segments of degree {degree}; allowed are 1 or more that follow, "
                      "of degree 0 to 5")
    if count > most:
        reader.refuse(f"has inputs of more than {MOST_SEGMENTS} segments, the most that are taken here")
    return Signal([read_segment(reader, degree) for _ in range(count)])


def read_segment(reader: Reader, degree: int) -> Segment:
    end, origin, *c = reader.take(f"{degree + 3}d")
    if not all(map(math.isfinite, c)) or not math.isfinite(origin) or math.isnan(end):
        reader.refuse("has an input that is not finite")
    return Segment(end, origin, tuple(c))


def put_clock(clock: Clock) -> bytes:
    return struct.pack("<ddI", clock.time, clock.next_time, int(clock.stop))


def put_rows(head: bytes, rows: Sequence[Row], stride: int) -> bytearray:
    """The rows behind a clock or an error."""
    data = bytearray(head) + struct.pack("<IQ", stride, len(rows))
    for row in rows:
        if len(row.values) != stride - 2:
            raise Error(f"the sample at t = {row.time} s has {len(row.values)} values; allowed are {stride - 2}")
        try:
            data += struct.pack("<dd", row.time, float(row.jump))
            for k in range(0, stride - 2, AT_ONCE):
                some = row.values[k:k + AT_ONCE]
                data += struct.pack(f"<{len(some)}d", *some)
        except struct.error:
            raise Error(f"the sample at t = {row.time} s has {list(row.values)[:10]}; allowed are numbers") from None
    return data


def read_clock(reader: Reader) -> Clock:
    time_, next_time, stop = reader.take("ddI")
    if stop > 3:
        reader.refuse(f"gives {stop} as the reason to stop; allowed are 0 to 3")
    return Clock(time_, next_time, Stop(stop))


def read_state(data: memoryview, what: str) -> int:
    """The identity of a saved one."""
    reader = Reader(data, what)
    (state,) = reader.take("q")
    reader.end()
    return state


def read_samples(data: memoryview, info: Info, room: int) -> Tuple[Clock, List[Row]]:
    reader = Reader(data, "samples")
    return read_clock(reader), read_rows(reader, info, room)


def read_rows(reader: Reader, info: Info, room: int) -> List[Row]:
    """All that is left."""
    stride, count = reader.take("IQ")
    if count > room or (count and stride != info.row_size()):
        reader.refuse(f"has {count} rows of {stride} numbers; allowed are up to {room} of {info.row_size()}")
    rows = []
    for _ in range(count):
        time_, jump, *values = reader.take(f"{stride}d")
        check_jump(time_, jump)
        rows.append(Row(time_, values, jump == 1.0))
    reader.end()
    return rows


def put_error(error: Error) -> bytes:
    return struct.pack("<I", error.code) + put_text(printable(str(error), LONGEST_TOLD))


def read_error(data: memoryview, given: Optional[Info] = None) -> Error:
    """given: of an advance, whose rows up to the error may follow. They are not of use any more."""
    reader = Reader(data, "error")
    (code,) = reader.take("I")
    error = Error(printable(reader.text(LONGEST_SENTENCE)), code if 1 <= code <= 6 else 6)
    if given is not None and reader.left():
        read_rows(reader, given, reader.left())
    reader.end()
    return error
