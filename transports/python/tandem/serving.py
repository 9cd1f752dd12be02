# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Offers a subsystem to tandem: on an address, or to the run that started this program (spawn:)."""

from __future__ import annotations

import errno
import os
import selectors
import signal
import socket
import sys
import threading
import time
from typing import Any, Callable, Optional, Sequence

from . import wire
from .address import Listener
from .contract import Error, Parameter
from .options import Options
from .printable import printable
from .session import Make, Session


def serve(make: Make, address: Optional[str] = None, once: bool = False, deadline: float = 5.0,
          idle: float = 3600.0, sessions: int = 64, parameters: Sequence[Parameter] = ()) -> None:
    """Serves what `make(values)` returns, an instance for each session: at `address` ("tcp://HOST:PORT",
    port 0 for a free one, or "unix:PATH"; the address is printed), or, without one, as the command line says, from the
    first of its words --listen URI, --once, --sessions N, --deadline S and --idle S on; or to the run that has started
    this program by spawn:. once: one session and no more (a peer that says no whole hello has none); deadline [s]: for
    a session's first request, for a frame to come whole and for a reply to be taken; idle [s]: from one request to the
    next; sessions: the most at a time. parameters: all that it takes; then `values` has a number or a word for each,
    what is not given as it is declared; without them it has the texts that the client gave. SIGTERM and Ctrl-C end
    the program; so does a command line that is not right, with a sentence and status 2."""
    options = Options(address, once, deadline, idle, sessions)
    if address is not None:
        options.check()
        _Server(Listener(address), make, options, parameters).run()
        return
    try:
        options.read(sys.argv[1:])
        options.check()
        work = _work(make, options, parameters)
    except Error as error:
        print(f"{sys.argv[0]}: {error}", file=sys.stderr)
        raise SystemExit(2) from None
    work()


def _work(make: Make, options: Options, parameters: Sequence[Parameter]) -> Callable[[], None]:
    """That of a server, or of the one session of the program that started this one."""
    number = os.environ.get("TANDEM_FD")
    if options.address is not None:
        return _Server(Listener(options.address), make, options, parameters).run
    if number is None:
        raise Error("an address is needed: --listen URI")
    try:
        sock = socket.socket(fileno=int(number))
    except (ValueError, OSError):
        raise Error(f"the variable TANDEM_FD is '{number}'; allowed is the number of a socket that is open") from None
    sock.set_inheritable(False)  # it is not for programs that this one starts
    channel = wire.Channel(sock, "the program that started this one")
    return lambda: _serve_one(Session(channel, make, options.deadline, options.idle, parameters))


class _Server:
    """Sessions in threads of their own, so many at a time."""

    def __init__(self, listener: Listener, make: Make, options: Options, parameters: Sequence[Parameter]) -> None:
        self._listener, self._make, self._options, self._parameters = listener, make, options, parameters
        self._lock = threading.Lock()
        self._open = 0
        self._shortage = ""  # why the last connection could not be taken
        self._waits = selectors.DefaultSelector()

    def run(self) -> None:
        try:
            self._catch_signals()
            print(f"serving at {self._listener.place}", flush=True)
            while True:
                sock = self._accept()
                if sock is not None and self._options.once:
                    session = self._session(sock)
                    _serve_one(session)
                    if session.greeted:
                        return
                elif sock is not None:
                    self._take(sock)
        finally:
            if threading.current_thread() is threading.main_thread():
                signal.set_wakeup_fd(-1)
            self._waits.close()
            self._listener.close()

    def _catch_signals(self) -> None:
        """One that comes just before the server waits for a connection ends the wait, too."""
        self._listener.socket.setblocking(False)
        self._waits.register(self._listener.socket, selectors.EVENT_READ)
        if threading.current_thread() is not threading.main_thread():
            return
        self._woken, self._wakes = socket.socketpair()
        self._wakes.setblocking(False)
        self._waits.register(self._woken, selectors.EVENT_READ)
        signal.set_wakeup_fd(self._wakes.fileno(), warn_on_full_buffer=False)
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, _end)

    def _accept(self) -> Optional[socket.socket]:
        """The next connection; None if there is none, or no descriptor or memory for it: then it waits."""
        self._waits.select()
        try:
            sock, _ = self._listener.socket.accept()
            sock.setblocking(True)
            self._shortage = ""
            return sock
        except BlockingIOError:
            return None
        except OSError as error:
            if error.errno != errno.ECONNABORTED:
                self._wait_out(str(error.strerror))
            return None

    def _wait_out(self, shortage: str) -> None:
        """Told once, and tried again at leisure."""
        if shortage != self._shortage:
            _log(f"further connections wait: {shortage}")
        self._shortage = shortage
        time.sleep(0.1)

    def _session(self, sock: socket.socket) -> Session:
        channel = wire.Channel(sock, self._listener.place)
        return Session(channel, self._make, self._options.deadline, self._options.idle, self._parameters)

    def _take(self, sock: socket.socket) -> None:
        with self._lock:
            free = self._open < self._options.sessions
            self._open += free
        if not free:
            self._turn_away(sock, f"has {self._options.sessions} sessions open, the most that it allows")
            return
        try:
            threading.Thread(target=self._serve, args=(self._session(sock),), daemon=True).start()
        except (RuntimeError, MemoryError) as error:
            self._leave()
            self._turn_away(sock, f"can make no thread: {error}")

    def _serve(self, session: Session) -> None:
        try:
            _serve_one(session)
        finally:
            self._leave()

    def _leave(self) -> None:
        with self._lock:
            self._open -= 1

    def _turn_away(self, sock: socket.socket, why: str) -> None:
        """Its request is not awaited: whoever connects and says nothing costs nothing."""
        _log(f"turned away, as the server {why}")
        channel = wire.Channel(sock, self._listener.place)
        try:
            channel.send(wire.Type.ERROR, 1, wire.put_error(Error(f"the server {why}; try again later", 2)), 0.1)
        except Error:  # gone already
            pass
        channel.close()


def _end(*_: Any) -> None:
    raise SystemExit(0)


def _serve_one(session: Session) -> None:
    try:
        session.serve()
    except Error as error:
        _log(f"session ends: {error}")


def _log(sentence: str) -> None:
    """What a peer has sent may be in it; and nobody may listen."""
    try:
        print("tandem: " + printable(sentence) + "\n", end="", file=sys.stderr, flush=True)
    except OSError:
        pass
