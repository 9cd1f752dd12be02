# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Peers of zmq: for the faults, by libzmq through ctypes: they do what the protocol forbids."""

import contextlib
import ctypes
import os
import struct
import time

import tandem
from tandem import wire

DEALER, ROUTER, ROUTING_ID = 5, 6, 5
LINGER, SEND_TIMEOUT, RECEIVE_TIMEOUT, LAST_ENDPOINT = 17, 28, 27, 32
CURVE_SERVER, CURVE_PUBLIC, CURVE_SECRET, CURVE_SERVER_KEY = 47, 48, 49, 50
SEND_MORE, RECEIVE_MORE = 2, 13
KNOCK = b"TANDEM\r\n"
LONGEST = 1 << 21  # bytes of a message that is taken here

zmq = ctypes.CDLL("libzmq.so.5", use_errno=True)
for name in ("zmq_ctx_new", "zmq_socket"):
    getattr(zmq, name).restype = ctypes.c_void_p


def check(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), "ZeroMQ")
    return result


class Socket:
    """A socket of ZeroMQ with a context of its own; each message is one frame."""

    def __init__(self, kind, keys=(), context=None):
        self._context = context or ctypes.c_void_p(zmq.zmq_ctx_new())
        self._owns = context is None
        self._socket = ctypes.c_void_p(zmq.zmq_socket(self._context, kind))
        self._buffer = ctypes.create_string_buffer(LONGEST)
        self._open = True
        for option, value in keys:
            self._set(option, value)

    def _set(self, option, value):
        data = value if isinstance(value, bytes) else struct.pack("i", value)
        check(zmq.zmq_setsockopt(self._socket, option, data, len(data)))

    def bind(self, address):
        check(zmq.zmq_bind(self._socket, address.encode()))
        place, size = ctypes.create_string_buffer(256), ctypes.c_size_t(256)
        check(zmq.zmq_getsockopt(self._socket, LAST_ENDPOINT, place, ctypes.byref(size)))
        return place.value.decode()

    def connect(self, address):
        check(zmq.zmq_connect(self._socket, address.encode()))

    def follow(self, kind, keys):
        """A socket that takes over the context; this one is to be closed."""
        self._owns = False
        follower = Socket(kind, keys, self._context)
        follower._owns = True
        return follower

    def sendall(self, data, more=False):
        if not self._open:
            raise OSError("closed")
        self._set(SEND_TIMEOUT, 3000)
        check(zmq.zmq_send(self._socket, bytes(data), len(data), SEND_MORE if more else 0))

    def message(self, seconds):
        """The next one; None if none came by then."""
        self._set(RECEIVE_TIMEOUT, int(1000 * seconds))
        size = zmq.zmq_recv(self._socket, self._buffer, LONGEST, 0)
        return None if size < 0 else self._buffer.raw[:min(size, LONGEST)]

    def shutdown(self, how=None):
        """What was sent goes out within 0.3 s, and then the connection."""
        if self._open:
            self._set(LINGER, 300)
            zmq.zmq_close(self._socket)
            self._open = False
        if self._owns:
            zmq.zmq_ctx_term(self._context)
            self._owns = False

    close = shutdown

    def __enter__(self):
        return self

    def __exit__(self, *ignored):
        self.close()


@contextlib.contextmanager
def as_error():
    """What the system refuses, as a channel tells it."""
    try:
        yield
    except OSError as error:
        raise tandem.Error(f"the connection broke: {error}", 5) from None


class Channel(wire.Channel):
    """Frames of one session."""

    def __init__(self, raw, peer):  # not that of a plain socket
        self.raw, self.peer, self._begun = raw, peer, None

    def send(self, kind, number, payload, deadline):
        with as_error():
            self.raw.sendall(wire.HEADER.pack(len(payload), kind, number) + payload)

    def wait(self, seconds):
        with as_error():
            self._begun = self._begun or self.raw.message(seconds)
        return self._begun is not None

    def receive(self, deadline, until=None):
        if not self.wait(deadline):
            raise tandem.Error("no frame came within the deadline", 5)
        data, self._begun = self._begun, None
        length, kind, number = wire.HEADER.unpack(data[:16])
        return wire.Type(kind), number, memoryview(data)[16:]

    def close(self):
        self.raw.close()


class Listener:
    """Answers one knock at tcp://127.0.0.1:* or ipc://PATH with the address of a socket for the session."""

    def __init__(self, address, keys):
        self._address, self._keys, self._door = address, keys, Socket(ROUTER, keys)
        self.uri = "zmq:" + self._door.bind(address)

    def accept(self):
        peer = self._door.message(30.0)
        if peer is None or self._door.message(1.0) != KNOCK:
            raise OSError("no knock")
        session = self._door.follow(DEALER, self._keys)
        place = session.bind(self._address + ("-1" if self._address.startswith("ipc:") else ""))
        self._door.sendall(peer, more=True)
        self._door.sendall(place.encode())
        self._door.close()
        return Channel(session, "peer")


def connect(address, keys, seconds):
    """A socket for a session with the server at tcp://HOST:PORT or ipc://PATH, or OSError."""
    token = os.urandom(16).hex().encode()
    with Socket(DEALER, keys) as door:
        door.connect(address)
        door.sendall(KNOCK, more=True)
        door.sendall(token)
        place = door.message(seconds)
    if place is None:
        raise OSError("no answer to the knock")
    session = Socket(DEALER, [*keys, (ROUTING_ID, token)])
    session.connect(place.decode())
    return session


def greeting():
    """What ZMTP 3.0 begins with, without keys: signature, version, mechanism, and the socket's type."""
    ready = b"\x05READY\x0bSocket-Type" + struct.pack(">I", 6) + b"DEALER"
    return b"\xff" + bytes(8) + b"\x7f\x03\x00NULL" + bytes(16 + 1 + 31) + bytes([4, len(ready)]) + ready


def huge_message(size):
    """The beginning of a message that announces so many bytes."""
    return greeting() + b"\x02" + struct.pack(">Q", size) + bytes(64)


def wait_for_end(sock, seconds):
    """Whether the other side closes within so many seconds."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        sock.settimeout(max(end - time.monotonic(), 1e-3))
        try:
            if not sock.recv(4096):
                return True
        except TimeoutError:
            return False
        except OSError:
            return True
    return False
