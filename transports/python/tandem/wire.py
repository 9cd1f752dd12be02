# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The payloads of docs/wire_protocol.md: bytes to values and back."""

from __future__ import annotations

import array
import math
import struct
from typing import List, NamedTuple, Optional, Sequence, Tuple

from .channel import HEADER, LONGEST, Channel, Payload, Type
from .contract import Abilities, Clock, Error, Info, Parameter, Part, Port, Row, Segment, Signal, Stop
from .parameters import put_declared, read_declared
from .printable import printable
from .reader import Reader, put_text
from .reply_checks import check_jump

__all__ = ["HEADER", "LONGEST", "Channel", "Payload", "Reader", "Type"]

VERSION = 1
# Capabilities: held outputs and sampled subsystems, declared parameters, nominal values.
CARRIES_HELD, CARRIES_PARAMETERS, CARRIES_NOMINAL = 1, 2, 4
CAPABILITIES = CARRIES_HELD | CARRIES_PARAMETERS | CARRIES_NOMINAL
HOLDS = 128  # a bit of the abilities
ABILITIES = sum(Abilities)  # the bits that are known here
MAGIC = b"TANDEM\r\n"
LONGEST_SENTENCE = 1 << 20  # bytes that are read
LONGEST_TOLD = 4000  # bytes of a sentence of ours
#: that a request may have: as objects they take up to 400 bytes each
MOST_SEGMENTS = 1 << 17
AT_ONCE = 1 << 12  # numbers of a row that are put into a reply


def put_hello(text: str, declared: Optional[Sequence[Parameter]] = None) -> bytes:
    """declared: of a reply to one who speaks of parameters."""
    hello = MAGIC + struct.pack("<IIQI", VERSION, VERSION, LONGEST, CAPABILITIES) + put_text(text)
    return hello if declared is None else hello + put_declared(declared)


class Hello(NamedTuple):
    """The first request, and its reply."""

    lowest: int
    highest: int  #: version
    longest: int  #: payload in bytes
    capabilities: int
    text: str
    declared: Sequence[Parameter] = ()


def read_hello(data: memoryview, asked_with: int = 0) -> Hello:
    """asked_with: of a reply, the capabilities of the request."""
    reader = Reader(data, "hello")
    if bytes(data[:8]) != MAGIC:
        reader.refuse("does not begin with TANDEM, so the peer speaks something else")
    reader.take("8s")
    hello = Hello(*reader.take("IIQI"), reader.text(LONGEST_SENTENCE))
    if hello.capabilities & asked_with & CARRIES_PARAMETERS:
        hello = hello._replace(declared=read_declared(reader))
    reader.end()
    return hello


def put_info(info: Info, capabilities: int = CAPABILITIES) -> bytes:
    """capabilities: of both sides."""
    bits = int(info.abilities) | (HOLDS if info.holds() else 0)
    parts = [put_text(info.name), struct.pack("<I", bits)]
    for ports in (info.inputs, info.outputs):
        parts.append(struct.pack("<I", len(ports)))
        for p in ports:
            parts += [put_text(p.name), put_text(p.unit), struct.pack("<iid", p.size, p.derivatives, p.start)]
    parts.append(struct.pack("<I", len(info.feedthrough)))
    parts += [struct.pack("<ii", *pair) for pair in info.feedthrough]
    if info.holds():
        parts += [struct.pack("<I", port.held) for port in info.outputs]
    if Abilities.SAMPLED in info.abilities:
        parts.append(struct.pack("<dd", info.period, info.latency))
    if capabilities & CARRIES_NOMINAL:
        parts += [struct.pack("<d", port.nominal) for port in info.outputs]
    return b"".join(parts)


def read_info(data: memoryview, capabilities: int = CAPABILITIES) -> Info:
    reader = Reader(data, "info")
    name = reader.name()
    (bits,) = reader.take("I")
    ports: List[List[Port]] = []
    for _ in range(2):
        ports.append([Port(reader.name(), reader.name(), *reader.take("iid"))
                      for _ in range(reader.count(24))])
    feedthrough = [reader.take("ii") for _ in range(reader.count(8))]
    info = Info(name, ports[0], ports[1], feedthrough, Abilities(bits & ABILITIES))
    read_held(reader, bool(bits & HOLDS), info)
    if Abilities.SAMPLED in info.abilities:
        info.period, info.latency = reader.take("dd")
    for port in info.outputs if capabilities & CARRIES_NOMINAL else ():
        (port.nominal,) = reader.take("d")
    reader.end()
    return info


def read_held(reader: Reader, told: bool, info: Info) -> None:
    """told: a flag for each output stands there. Those of a sampled subsystem are held in any case."""
    for port in info.outputs:
        (held,) = reader.take("I") if told else (int(Abilities.SAMPLED in info.abilities),)
        if held > 1:
            reader.refuse(f"gives {held} for whether output '{port.name}' is held; allowed are 0 and 1")
        port.held = held == 1


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


def sound_rows(rows: List[Row], stride: int) -> List[Row]:
    """Those before the first one that is wrong."""
    for count, row in enumerate(rows):
        try:
            put_rows(b"", [row], stride)
        except Exception:  # whatever the model has put there
            return rows[:count]
    return rows


def read_clock(reader: Reader) -> Clock:
    time_, next_time, stop = reader.take("ddI")
    if stop > 3:
        reader.refuse(f"gives {stop} as the reason to stop; allowed are 0 to 3")
    return Clock(time_, next_time, Stop(stop))


def put_sample(t: float, part: int, u: Sequence[float]) -> bytes:
    return struct.pack("<dI", t, part) + put_list(u)


def read_sample(data: memoryview, inputs: int) -> Tuple[float, Part, array.array]:
    reader = Reader(data, "sample")
    t, part = reader.take("dI")
    if not (math.isfinite(t) and 1 <= part <= 3):
        reader.refuse(f"has t {t} and the parts {part}; allowed are a finite time, and 1 to 3")
    check_inputs(reader, reader.count(8), inputs)
    u = reader.take_doubles(inputs)
    if not all(map(math.isfinite, u)):
        reader.refuse("has an input that is not finite")
    reader.end()
    return t, Part(part), u


def put_list(values: Sequence[float]) -> bytes:
    return struct.pack(f"<I{len(values)}d", len(values), *values)


def read_sampled(data: memoryview, outputs: int) -> Tuple[Clock, List[float]]:
    reader = Reader(data, "sample")
    clock = read_clock(reader)
    count = reader.count(8)
    if count != outputs:
        reader.refuse(f"has {count} outputs; allowed are {outputs}")
    values = list(reader.take_doubles(count))
    reader.end()
    return clock, values


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


def read_error(data: memoryview, given: Optional[Info] = None, of_hello: bool = False) -> Error:
    """given: of an advance, whose rows up to the error may follow. They are not of use any more. of_hello: parameters
    that the subsystem's kind declares may follow."""
    reader = Reader(data, "error")
    (code,) = reader.take("I")
    error = Error(printable(reader.text(LONGEST_SENTENCE)), code if 1 <= code <= 6 else 6)
    if given is not None and reader.left():
        read_rows(reader, given, reader.left())
    if of_hello and reader.left():
        error.parameters = read_declared(reader)
    reader.end()
    return error
