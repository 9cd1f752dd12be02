# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Offers a subsystem to tandem: on an address, or to the run that started this program (spawn:)."""

from __future__ import annotations

import os
import signal
import socket
import sys
import threading
import traceback
from typing import Any, Callable, Dict, List, Optional, Tuple

from . import wire
from .address import listen
from .contract import Abilities, Error, Info, Row

Make = Callable[[Dict[str, str]], Any]


class Session:
    """One connection: answers requests until the peer says bye or is gone. `make` gets the parameters that the
    client gave, and returns a subsystem: an object with info(), initialize() and advance() as FixedStep has
    them, with the ability to save states save_state(), restore_state(id), release_state(id), and with that to give
    them as bytes serialize_state(id), deserialize_state(bytes)."""

    def __init__(self, channel: wire.Channel, make: Make, deadline: float = 5.0,
                 idle: Optional[float] = None) -> None:
        self._channel, self._make = channel, make
        self._deadline, self._idle = deadline, idle
        self._number = 0
        self._subsystem: Any = None
        self._info: Optional[Info] = None
        self._initialized = False
        self._longest = wire.LONGEST

    def serve(self) -> None:
        try:
            while self._answer():
                pass
        except Error as error:
            self._try_to_tell(error)
            raise
        finally:
            self._channel.close()

    def _answer(self) -> bool:
        last, self._number = self._number, 0  # of what goes wrong before the request's own is known to be right
        frame = self._channel.receive(self._idle, self._deadline)
        if frame is None:
            return False
        kind, number, data = frame
        if number != last + 1:
            raise Error(f"the request has the number {number}; allowed is {last + 1}", 3)
        self._number = number
        if kind == wire.Type.BYE:
            self._say_bye()
            return False
        self._check_order(kind)
        self._handle(kind, data)
        return True

    def _say_bye(self) -> None:
        """The peer need not wait for it."""
        try:
            self._reply(wire.Type.BYE, b"")
        except Error:
            pass

    def _check_order(self, kind: wire.Type) -> None:
        early = kind in (wire.Type.INFO, wire.Type.INITIALIZE, wire.Type.PING)
        if kind == wire.Type.HELLO:
            sound = self._subsystem is None
        else:
            sound = self._subsystem is not None and (early or self._initialized)
        if not sound:
            raise Error(f"the request '{kind.name.lower()}' is out of order; allowed is hello once, then info, "
                        "then initialize before all others", 3)

    def _handle(self, kind: wire.Type, data: memoryview) -> None:
        handler = {wire.Type.HELLO: self._hello, wire.Type.INFO: self._tell_info,
                   wire.Type.INITIALIZE: self._initialize, wire.Type.ADVANCE: self._advance,
                   wire.Type.SAVE: self._save, wire.Type.RESTORE: self._restore,
                   wire.Type.RELEASE: self._release, wire.Type.SERIALIZE: self._serialize,
                   wire.Type.DESERIALIZE: self._deserialize, wire.Type.PING: self._ping}.get(kind)
        if handler is None:
            raise Error(f"'{kind.name.lower()}' is no request", 3)
        handler(data)

    def _hello(self, data: memoryview) -> None:
        lowest, highest, self._longest, text = wire.read_hello(data)
        if not lowest <= wire.VERSION <= highest:
            raise Error(f"the peer speaks version {lowest} to {highest} of the protocol; allowed is "
                        f"{wire.VERSION}", 2)
        if self._longest < 4096:
            raise Error(f"the peer takes payloads of up to {self._longest} bytes; allowed are 4096 or more", 2)
        self._subsystem = _asked(lambda: self._make(_parameters(text)))
        self._info = self._subsystem.info()
        self._reply(wire.Type.HELLO, wire.put_hello("tandem for Python"))

    def _tell_info(self, data: memoryview) -> None:
        self._reply(wire.Type.INFO, wire.put_info(self._known()))

    def _known(self) -> Info:
        assert self._info is not None
        return self._info

    def _rows(self, room: int, call: Callable[[List[Row], int], Any]) -> None:
        stride = self._known().row_size()
        room = min(room, (self._longest - 32) // (8 * stride))
        rows: List[Row] = []

        def payload() -> bytes:
            clock = call(rows, room)
            return wire.put_clock(clock) + wire.put_rows(rows, stride)

        try:
            self._reply(wire.Type.SAMPLES, _asked(payload))
        except Error as error:
            self._reply(wire.Type.ERROR, wire.put_error(error) + _sound_rows(rows, stride))

    def _initialize(self, data: memoryview) -> None:
        t_start, t_stop, room, u0 = wire.read_initialize(data, self._known().input_size())
        self._initialized = True
        self._rows(room, lambda rows, n: self._subsystem.initialize(t_start, t_stop, u0, rows, n))

    def _advance(self, data: memoryview) -> None:
        t_limit, land, room, u = wire.read_advance(data, self._known().input_size())
        self._rows(room, lambda rows, n: self._subsystem.advance(t_limit, land, u, rows, n))

    def _state(self, kind: wire.Type, call: Callable[[], bytes]) -> None:
        bytes_too = kind in (wire.Type.SERIALIZE, wire.Type.DESERIALIZE)
        ability = Abilities.SERIALIZES_STATE if bytes_too else Abilities.SAVES_STATE

        def payload() -> bytes:
            if not self._known().abilities & ability:
                what = "give its state as bytes" if bytes_too else "save its state"
                raise Error(f"subsystem '{self._known().name}' has no ability to {what}", 2)
            return call()

        try:
            self._reply(kind, _asked(payload))
        except Error as error:
            self._reply(wire.Type.ERROR, wire.put_error(error))

    def _save(self, data: memoryview) -> None:
        self._state(wire.Type.SAVE, lambda: _identity(self._subsystem.save_state()))

    def _restore(self, data: memoryview) -> None:
        (state,) = wire.Reader(data, "restore").take("q")
        self._state(wire.Type.RESTORE, lambda: wire.put_clock(self._subsystem.restore_state(state)))

    def _release(self, data: memoryview) -> None:
        (state,) = wire.Reader(data, "release").take("q")

        def release() -> bytes:
            self._subsystem.release_state(state)
            return b""

        self._state(wire.Type.RELEASE, release)

    def _serialize(self, data: memoryview) -> None:
        (state,) = wire.Reader(data, "serialize").take("q")
        self._state(wire.Type.SERIALIZE, lambda: self._bytes_of(state))

    def _bytes_of(self, state: int) -> bytes:
        data = bytes(self._subsystem.serialize_state(state))
        if len(data) > self._longest:
            raise Error(f"the state has {len(data)} bytes; a reply may have up to {self._longest}", 2)
        return data

    def _deserialize(self, data: memoryview) -> None:
        self._state(wire.Type.DESERIALIZE, lambda: _identity(self._subsystem.deserialize_state(bytes(data))))

    def _ping(self, data: memoryview) -> None:
        self._reply(wire.Type.PING, bytes(data))

    def _reply(self, kind: wire.Type, payload: bytes) -> None:
        self._channel.send(kind, self._number, payload, self._deadline)

    def _try_to_tell(self, error: Error) -> None:
        try:
            self._reply(wire.Type.ERROR, wire.put_error(error))
        except Error:
            pass


def _sound_rows(rows: List[Row], stride: int) -> bytes:
    """Those before the first one that is wrong."""
    for count in range(len(rows), 0, -1):
        try:
            return wire.put_rows(rows[:count], stride)
        except Error:
            pass
    return wire.put_rows([], stride)


def _identity(state: int) -> bytes:
    return int(state).to_bytes(8, "little", signed=True)


def _asked(call: Callable[[], Any]) -> Any:
    """What the model raises becomes an error with its sentence; the traceback goes to standard error."""
    try:
        return call()
    except Error:
        raise
    except Exception as error:
        traceback.print_exc()
        raise Error(f"{type(error).__name__}: {error}", 6) from None


def _parameters(text: str) -> Dict[str, str]:
    parameters: Dict[str, str] = {}
    for pair in filter(None, text.split("&")):
        key, equals, value = pair.partition("=")
        if not equals or not key:
            raise Error(f"the parameters have '{pair}' where key=value is allowed")
        parameters[key] = value
    return parameters


def serve(make: Make, address: Optional[str] = None, once: bool = False, deadline: float = 5.0) -> None:
    """Serves what `make(parameters)` returns, an instance for each session: at `address` ("tcp://HOST:PORT",
    port 0 for a free one, or "unix:PATH"; the address is printed), or, without one, at --listen URI of the
    command line, or to the run that has started this program by spawn:. SIGTERM and Ctrl-C end the program; so does
    a command line that is not right, with a sentence and status 2."""
    if address is None:
        _serve_as_told(make, once, deadline)
    else:
        _serve_at(listen(address), make, once, deadline)


def _serve_as_told(make: Make, once: bool, deadline: float) -> None:
    if "--listen" not in sys.argv[:-1] and "TANDEM_FD" in os.environ:
        sock = socket.socket(fileno=int(os.environ["TANDEM_FD"]))
        _serve_one(Session(wire.Channel(sock, "the program that started this one"), make, deadline))
        return
    try:
        if "--listen" not in sys.argv[:-1]:
            raise Error("an address is needed: --listen URI")
        found = listen(sys.argv[sys.argv.index("--listen") + 1])
    except Error as error:
        print(f"{sys.argv[0]}: {error}", file=sys.stderr)
        raise SystemExit(2) from None
    _serve_at(found, make, once, deadline)


def _serve_at(found: Tuple[socket.socket, str], make: Make, once: bool, deadline: float) -> None:
    listener, place = found
    try:
        if threading.current_thread() is threading.main_thread():
            for number in (signal.SIGTERM, signal.SIGINT):
                signal.signal(number, _end)
        print(f"serving at {place}", flush=True)
        while True:
            sock, _ = listener.accept()
            session = Session(wire.Channel(sock, place), make, deadline)
            if once:
                _serve_one(session)
                return
            threading.Thread(target=_serve_one, args=(session,), daemon=True).start()
    finally:
        listener.close()
        if place.startswith("unix:"):
            os.unlink(place[5:])


def _end(*_: Any) -> None:
    raise SystemExit(0)


def _serve_one(session: Session) -> None:
    try:
        session.serve()
    except Error as error:
        print(f"session ends: {error}", file=sys.stderr)
