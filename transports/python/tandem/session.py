# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The serving side of one connection."""

from __future__ import annotations

import time
import traceback
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from . import wire
from .contract import Abilities, Error, Info, Parameter, Row
from .parameters import Value, put_declared, texts_of, values_of
from .printable import is_printable, printable
from .states import States

Make = Callable[[Dict[str, Value]], Any]

#: bytes that rows may take until they are put into a reply: 32 a number, and about 250 a row
MOST_ROW_MEMORY = 3 << 24


class Session:
    """One connection: answers requests until the peer says bye or is gone. `make` gets the parameters that the
    client gave, by the declaration `parameters` or, without one, as texts, and returns a subsystem: an object with info(), initialize() and advance() as FixedStep has
    them, or sample() as Sampled has it, with the ability to save states save_state(), restore_state(id), release_state(id), and with that to give
    them as bytes serialize_state(id), deserialize_state(bytes). deadline: seconds for the first request, for a frame to
    come whole, and for a reply to be taken; idle: from one request to the next."""

    def __init__(self, channel: wire.Channel, make: Make, deadline: float = 5.0, idle: float = 3600.0,
                 parameters: Sequence[Parameter] = ()) -> None:
        self._channel, self._make, self._declared = channel, make, parameters
        self._capabilities = 0  # of both sides
        self._deadline, self._idle = deadline, idle
        self._number = 0
        self.greeted = False  #: the peer has said a whole hello
        self._subsystem: Any = None
        self._info: Optional[Info] = None
        self._initialized = False
        self._longest = wire.LONGEST
        self._states = States()

    def serve(self) -> None:
        """To the end of the session. Raises Error for what broke the protocol or the connection, told to the peer if
        it can be."""
        try:
            while _asked(self._answer):
                pass
        except Error as error:
            self._try_to_tell(error)
            raise
        finally:
            self._channel.close()

    def _answer(self) -> bool:
        last, self._number = self._number, 0  # of what goes wrong before the request's own is known to be right
        frame = self._next()
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

    def _next(self) -> Optional[Tuple[wire.Type, int, memoryview]]:
        """The next request. The hello has one deadline for the wait and for all of it."""
        first = self._subsystem is None
        awaited, patience = ("hello", self._deadline) if first else ("request", self._idle)
        until = time.monotonic() + patience
        if not self._channel.wait(patience):
            raise Error(f"no {awaited} came within {patience:g} s, so the session ends", 5)
        return self._channel.receive(self._deadline, until if first else None)

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
                   wire.Type.DESERIALIZE: self._deserialize, wire.Type.SAMPLE: self._sample,
                   wire.Type.PING: self._ping}.get(kind)
        if handler is None:
            raise Error(f"'{kind.name.lower()}' is no request", 3)
        handler(data)

    def _hello(self, data: memoryview) -> None:
        hello = wire.read_hello(data)
        self._longest, self.greeted = hello.longest, True
        if not hello.lowest <= wire.VERSION <= hello.highest:
            raise Error(f"the peer speaks version {hello.lowest} to {hello.highest} of the protocol; allowed is "
                        f"{wire.VERSION}", 2)
        if self._longest < 4096:
            raise Error(f"the peer takes payloads of up to {self._longest} bytes; allowed are 4096 or more", 2)
        if not is_printable(hello.text):
            raise Error(f"the parameters hold what is no text: '{printable(hello.text, 200)}'")
        self._capabilities = hello.capabilities & wire.CAPABILITIES
        self._subsystem = _asked(lambda: self._make(values_of(self._declared, texts_of(hello.text))))
        self._info = self._subsystem.info()
        self._require_carried()
        self._reply(wire.Type.HELLO, wire.put_hello("tandem for Python", self._declared if self._tells() else None))

    def _tells(self) -> bool:
        """Whether the peer is told of parameters."""
        return bool(self._capabilities & wire.CARRIES_PARAMETERS)

    def _require_carried(self) -> None:
        """A peer that was written before held outputs would take them for continuous ones."""
        if (self._known().holds() or self._can(Abilities.SAMPLED)) and not self._capabilities & wire.CARRIES_HELD:
            raise Error(f"subsystem '{self._known().name}' has held outputs or is sampled, of which the peer does not "
                        "speak (capability 1)", 2)

    def _tell_info(self, data: memoryview) -> None:
        wire.Reader(data, "info").end()
        self._reply(wire.Type.INFO, wire.put_info(self._known(), self._capabilities))

    def _known(self) -> Info:
        assert self._info is not None
        return self._info

    def _room(self, asked: int) -> int:
        """Rows for one reply: as many as are asked for, fit into it, and have a place here; but one always has."""
        stride = self._known().row_size()
        here = max(1, MOST_ROW_MEMORY // (250 + 32 * stride))
        room = min(asked, (min(self._longest, wire.LONGEST) - 32) // (8 * stride), here)
        if room == 0:
            raise Error(f"there is room for no row of {8 * stride} bytes in a reply")
        return room

    def _rows(self, asked: int, call: Callable[[List[Row], int], Any]) -> None:
        stride, room = self._known().row_size(), self._room(asked)
        rows: List[Row] = []
        try:
            payload = _asked(lambda: wire.put_rows(wire.put_clock(call(rows, room)), rows, stride))
        except Error as error:
            sound = wire.sound_rows(rows, stride)
            self._reply(wire.Type.ERROR, wire.put_rows(wire.put_error(error), sound, stride))
        else:
            self._reply(wire.Type.SAMPLES, payload)

    def _initialize(self, data: memoryview) -> None:
        t_start, t_stop, room, u0 = wire.read_initialize(data, self._known().input_size())
        data.release()  # the memory of the request
        self._initialized = True
        self._rows(room, lambda rows, n: self._subsystem.initialize(t_start, t_stop, u0, rows, n))

    def _advance(self, data: memoryview) -> None:
        t_limit, land, room, u = wire.read_advance(data, self._known().input_size())
        data.release()

        def advance(rows: List[Row], n: int) -> Any:
            self._require(not self._can(Abilities.SAMPLED), "sampled and takes no own steps")
            return self._subsystem.advance(t_limit, land, u, rows, n)

        self._rows(room, advance)

    def _require(self, able: bool, what: str) -> None:
        if not able:
            raise Error(f"subsystem '{self._known().name}' is {what}", 2)

    def _sample(self, data: memoryview) -> None:
        t, part, u = wire.read_sample(data, self._known().input_size())
        data.release()

        def payload() -> bytes:
            self._require(self._can(Abilities.SAMPLED), "not sampled")
            clock, outputs = self._subsystem.sample(t, part, u)
            return wire.put_clock(clock) + wire.put_list(outputs)

        self._tell(wire.Type.SAMPLE, payload)

    def _state(self, kind: wire.Type, call: Callable[[], bytes]) -> None:
        bytes_too = kind in (wire.Type.SERIALIZE, wire.Type.DESERIALIZE)

        def payload() -> bytes:
            if not self._can(Abilities.SERIALIZES_STATE if bytes_too else Abilities.SAVES_STATE):
                what = "give its state as bytes" if bytes_too else "save its state"
                raise Error(f"subsystem '{self._known().name}' has no ability to {what}", 2)
            return call()

        self._tell(kind, payload)

    def _tell(self, kind: wire.Type, payload: Callable[[], bytes]) -> None:
        """What it gives, or its error."""
        try:
            reply = _asked(payload)
        except Error as error:
            self._reply(wire.Type.ERROR, wire.put_error(error))
        else:
            self._reply(kind, reply)

    def _can(self, ability: Abilities) -> bool:
        return bool(self._known().abilities & ability)

    def _save(self, data: memoryview) -> None:
        wire.Reader(data, "save").end()
        self._state(wire.Type.SAVE, self._save_state)

    def _save_state(self) -> bytes:
        """How large its states are is asked once. One that the peer is not told of is not kept."""
        self._states.require_room(self._states.usual)
        state = self._subsystem.save_state()
        try:
            if not self._states.usual and self._can(Abilities.SERIALIZES_STATE):
                self._states.usual = len(self._subsystem.serialize_state(state))
        except BaseException:
            self._subsystem.release_state(state)
            raise
        self._states.keep(state, self._states.usual)
        return _identity(state)

    def _restore(self, data: memoryview) -> None:
        state = wire.read_state(data, "restore")
        self._state(wire.Type.RESTORE, lambda: wire.put_clock(self._subsystem.restore_state(state)))

    def _release(self, data: memoryview) -> None:
        state = wire.read_state(data, "release")

        def release() -> bytes:
            self._subsystem.release_state(state)
            self._states.forget(state)
            return b""

        self._state(wire.Type.RELEASE, release)

    def _serialize(self, data: memoryview) -> None:
        state = wire.read_state(data, "serialize")
        self._state(wire.Type.SERIALIZE, lambda: self._bytes_of(state))

    def _bytes_of(self, state: int) -> bytes:
        data = self._subsystem.serialize_state(state)
        most = min(self._longest, wire.LONGEST)
        if len(data) > most:
            raise Error(f"the state has {len(data)} bytes; a reply may have up to {most}", 2)
        return bytes(data)

    def _deserialize(self, data: memoryview) -> None:
        self._state(wire.Type.DESERIALIZE, lambda: self._state_from(data))

    def _state_from(self, data: memoryview) -> bytes:
        size = len(data)
        self._states.require_room(size)
        given = bytes(data)
        data.release()
        state = self._subsystem.deserialize_state(given)
        self._states.keep(state, size)
        return _identity(state)

    def _ping(self, data: memoryview) -> None:
        self._reply(wire.Type.PING, data)

    def _reply(self, kind: wire.Type, payload: wire.Payload) -> None:
        self._channel.send(kind, self._number, payload, self._deadline)

    def _try_to_tell(self, error: Error) -> None:
        not_made = self._subsystem is None and self._tells()
        declared = put_declared(self._declared) if not_made else b""
        try:
            self._reply(wire.Type.ERROR, wire.put_error(error) + declared)
        except Error:
            pass


def _identity(state: int) -> bytes:
    return int(state).to_bytes(8, "little", signed=True)


def _asked(call: Callable[[], Any]) -> Any:
    """What the model raises becomes an error with its sentence; the traceback goes to standard error."""
    try:
        return call()
    except Error:
        raise
    except MemoryError:
        raise Error("there is no memory for it", 6) from None
    except Exception as error:
        traceback.print_exc()
        raise Error(f"{type(error).__name__}: {error}", 6) from None
