# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What a faulty server does in place of a reply."""

import os
import signal
import socket
import struct
import time

import tandem
from fault_peers import STRANGE
from tandem import wire

REPLIES = {"hello": 1, "info": 2, "initialize": 3, "advance": 6}  # requests before them answered soundly
NAN, INFINITY = float("nan"), float("inf")
FAREWELL = "no request came within 0.2 s, so the session ends"
WHERE = {1: "hello: ", 2: "info: ", 3: "initialize at t = 0 s: ", 4: " at t = 0 s"}  # by the number of the request


def said_at(request):
    """What an error has to say of the call that it ends, and of the time in the run."""
    return WHERE.get(request, "advance at t = ")


def with_payload(payload):
    """A frame of the same request with another payload."""
    return lambda f: put(0, "Q", len(payload))(f[:wire.HEADER.size]) + payload


def strange_info(size):
    """Names and units that hold control characters; an output of so many scalars."""
    info = tandem.Info("ra" + STRANGE, [tandem.Port("u", STRANGE, start=0.0)], [tandem.Port("x" + STRANGE, "m", size)])
    return with_payload(wire.put_info(info))


def gone(raw):
    raw.shutdown(socket.SHUT_RDWR)


def dribble(raw, frame):
    for byte in frame[:8]:
        raw.sendall(bytes([byte]))
        time.sleep(1.0)


def drop_within(raw, frame):
    raw.sendall(frame[: len(frame) // 2])
    gone(raw)


def drop_after(raw, frame):
    raw.sendall(frame)
    gone(raw)


def say_farewell(raw, frame):
    """The reply, and unasked why the session ends."""
    payload = wire.put_error(tandem.Error(FAREWELL, 5))
    raw.sendall(frame)
    raw.sendall(wire.HEADER.pack(len(payload), wire.Type.ERROR, 0) + payload)
    gone(raw)


def put(place, form, value):
    return lambda f: f[:place] + struct.pack("<" + form, value) + f[place + struct.calcsize("<" + form):]


def phase_faults():
    """(kind, reply, fault)."""
    for phase, at in REPLIES.items():
        yield f"dropped_before_{phase}", at, lambda raw, f: gone(raw)
        yield f"dropped_within_{phase}", at, drop_within
        yield f"dropped_after_{phase}", at, drop_after
        yield f"silent_at_{phase}", at, lambda raw, f: time.sleep(5.0)
        yield f"killed_at_{phase}", at, lambda raw, f: os.kill(os.getpid(), signal.SIGKILL)
        yield f"stopped_at_{phase}", at, lambda raw, f: os.kill(os.getpid(), signal.SIGSTOP)
    yield "one_byte_a_second", REPLIES["advance"], dribble


def changes():
    """(kind, reply, what becomes of its bytes)."""
    sample, last, first = 16 + 32, REPLIES["advance"], REPLIES["initialize"]  # where the first row stands; two more advances
    return [
        ("truncated_payload", last, lambda f: put(0, "Q", len(f) - 24)(f)[:-8]),
        ("length_one_more", last, lambda f: put(0, "Q", len(f) - 15)(f)),
        ("length_2_to_the_40", last, put(0, "Q", 1 << 40)),
        ("length_2_to_the_64_less_1", last, put(0, "Q", (1 << 64) - 1)),
        ("unknown_type", last, put(8, "I", 99)),
        ("type_of_another_reply", last, put(8, "I", 7)),
        ("number_of_another_request", last, put(12, "I", 5)),
        ("twice_the_same_reply", last - 1, lambda f: f + f),
        ("wrong_version", 1, put(24, "Q", (7 << 32) | 7)),
        ("text_protocol", 1, lambda f: b"HTTP/1.1 400 Bad Request\r\n\r\n"),
        ("no_magic", 1, put(16, "8s", b"GARBAGE!")),
        ("counts_of_ports", 2, put(16 + 12, "I", 0xFFFFFFFF)),
        ("wrong_row_size", last, put(16 + 20, "I", 17)),
        ("too_many_rows", last, put(16 + 24, "Q", 1 << 60)),
        ("unknown_stop", last, put(16 + 16, "I", 9)),
        ("value_not_a_number", last, put(sample + 16, "d", NAN)),
        ("value_infinite", last, put(sample + 16, "d", INFINITY)),
        ("time_not_a_number", last, put(sample, "d", NAN)),
        ("time_backward", last, lambda f: put(sample, "d", 0.05)(put(16, "d", 0.05)(f))),
        ("time_past_the_limit", last, lambda f: put(sample, "d", 50.0)(put(16, "d", 50.0)(f))),
        ("next_time_backward", last, put(24, "d", -1.0)),
        ("next_time_not_a_number", last, put(24, "d", NAN)),
        ("clock_beside_its_sample", last, put(16, "d", 0.25)),
        ("clock_not_a_number", last, put(16, "d", NAN)),
        ("first_value_not_a_number", first, put(sample + 16, "d", NAN)),
        ("first_time_not_a_number", first, put(sample, "d", NAN)),
        ("first_sample_beside_the_start", first, lambda f: put(sample, "d", 0.05)(put(16, "d", 0.05)(f))),
        ("first_clock_beside_its_sample", first, put(16, "d", 0.05)),
        ("no_first_sample", first, lambda f: with_payload(f[16:40] + bytes(8))(f)),
    ]


def sending(change):
    return lambda raw, frame: raw.sendall(change(frame))
