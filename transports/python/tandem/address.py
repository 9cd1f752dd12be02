# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Where peers meet: tcp://HOST:PORT, on this machine unless plain text may go beyond it, and unix:PATH."""

from __future__ import annotations

import errno
import os
import socket
import stat
from typing import Any, List, Tuple

from .contract import Error


class Listener:
    """Listens at an address. place: the same, with the port that was found."""

    def __init__(self, address: str) -> None:
        self._path = address[5:] if address.startswith("unix:") else ""
        try:
            if self._path:
                self.socket, self.place = _unix_listener(self._path), address
                self._file = os.lstat(self._path)
                return
            found = resolve(address, False)[0]
            self.socket = socket.create_server(found[4][:2], family=found[0])
            self.place = f"{address[:address.rindex(':')]}:{self.socket.getsockname()[1]}"
        except OSError as error:
            raise Error(f"no listening at {address}: {error}", 5) from None

    def close(self) -> None:
        """The file of a Unix socket goes with it, unless another has come in its place."""
        self.socket.close()
        try:
            if self._path and os.path.samestat(os.lstat(self._path), self._file):
                os.unlink(self._path)
        except OSError:  # gone already
            pass


def _unix_listener(path: str) -> socket.socket:
    if _is_stale(path):
        os.unlink(path)
    sock = socket.socket(socket.AF_UNIX)
    try:
        os.fchmod(sock.fileno(), 0o600)  # before there is a file to connect to
        sock.bind(path)
        sock.listen()
    except OSError:
        sock.close()
        raise
    return sock


def _is_stale(path: str) -> bool:
    """A socket that is left of a server which is gone."""
    if not os.path.exists(path) or not stat.S_ISSOCK(os.stat(path).st_mode):
        return False
    with socket.socket(socket.AF_UNIX) as probe:
        probe.settimeout(0.1)
        return probe.connect_ex(path) == errno.ECONNREFUSED


def split_address(address: str) -> Tuple[str, int]:
    host, colon, port = address[6:].rpartition(":")
    if not address.startswith("tcp://") or not colon or not port.isdigit():
        raise Error(f"address '{address}' is not of the form tcp://HOST:PORT or unix:PATH")
    if host == "*":
        raise Error(f"address '{address}' has the host '*'; allowed is a name or a number, which is 0.0.0.0 or [::] to "
                    "listen at every interface")
    return host.strip("[]"), int(port)


def resolve(address: str, allow_plaintext: bool) -> List[Any]:
    """What tcp://HOST:PORT stands for, as socket.getaddrinfo gives it; all of it has to be this machine."""
    host, port = split_address(address)
    places = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    for place in places:
        if not allow_plaintext and not is_loopback(str(place[4][0])):
            raise Error(f"address '{address}' is beyond this machine ({place[4][0]}), and tcp is plain text", 2)
    return places


def is_loopback(host: str) -> bool:
    return host.startswith("127.") or host == "::1"


def connected(address: str, deadline: float, allow_plaintext: bool) -> socket.socket:
    """To the first of the places that an address stands for which takes a connection."""
    unix = address.startswith("unix:")
    failure = OSError("the address stands for nothing")
    places = [(socket.AF_UNIX, address[5:])] if unix else [(p[0], p[4]) for p in resolve(address, allow_plaintext)]
    for family, place in places:
        sock = socket.socket(family)
        sock.settimeout(deadline)
        try:
            sock.connect(place)
            return sock
        except OSError as error:
            sock.close()
            failure = error
    raise failure
